

#include "ScanShapeFixtures.h"

// Where the grid lies and how it grows.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

TEST(CScanShapeGridMap2D, CellsLieOnIntegerKeysAtAnyResolution)
{
  for (const double resolution : {0.05, 0.1, 1.0 / 3, 0.1234567, 0.07})
  {
    SCOPED_TRACE(resolution);
    const CPose3D robot(-37.3, 21.9, 0);
    const Room room{-40.1, -34.2, 19.7, 23.3, 2.5};
    auto map = mapForRooms(resolution);
    ASSERT_TRUE(map.insertObservation(scanOf(room, robot), robot));
    const grid::GridFrame frame = map.frame();
    EXPECT_EQ(frame.resolution, resolution);
    EXPECT_FLOAT_EQ(map.getXMin(), static_cast<float>(frame.x0 * resolution));
    EXPECT_FLOAT_EQ(map.getYMax(), static_cast<float>(frame.yEnd() * resolution));
    const auto key = [&](double metres)
    { return static_cast<std::int32_t>(std::floor(metres / resolution)); };
    EXPECT_GT(cellAt(map, key(-36.5), key(22.5)), 0);
    EXPECT_EQ(cellAt(map, key(-36.5), key(23.3 + 2 * resolution)), 0);
    EXPECT_LT(std::min(cellAt(map, key(-36.5), key(23.3)), cellAt(map, key(-36.5), key(23.29))), 0);
  }
}

TEST(CScanShapeGridMap2D, AGridThatGrowsSaysTheSameAsOneThatIsLarge)
{
  const Room room{-25, 25, -14, 14, 2.5};
  auto growing = mapForRooms(), large = mapForRooms();
  large.setSize(-60, 60, -60, 60, 0.1f);
  for (const auto& robot : {CPose3D(0.4, 0.3, 0), CPose3D(14, 9, 0, 1, 0, 0),
                            CPose3D(-20, 11, 0, 2, 0, 0), CPose3D(-16, -12, 0, 3, 0, 0)})
  {
    ASSERT_TRUE(growing.insertObservation(scanOf(room, robot), robot));
    ASSERT_TRUE(large.insertObservation(scanOf(room, robot), robot));
    EXPECT_TRUE(large.frame() == (grid::GridFrame{0.1, -600, -600, 1200, 1200}));
    expectSameCells(growing, large);
  }
  EXPECT_LT(growing.frame().x0, -200);
  EXPECT_LT(growing.getSizeX(), 1000u);
}

/** As if a Voronoi diagram had been built (MRPT's own way to do so crashes). */
class MapWithVoronoi : public CScanShapeGridMap2D
{
 public:
  explicit MapWithVoronoi(const CScanShapeGridMap2D& map) : CScanShapeGridMap2D(map)
  {
    m_basis_map.setSize(0, 1, 0, 1, 0.1);
    m_voronoi_diagram.setSize(0, 1, 0, 1, 0.1);
    m_basis_map.fill(7);
    m_voronoi_diagram.fill(7);
  }
};

TEST(CScanShapeGridMap2D, AGridThatGrowsHasNoVoronoiDiagramOfTheFormerOne)
{
  MapWithVoronoi map(mapOf(Room()));
  ASSERT_EQ(map.getVoroniClearance(3, 3), 7);
  ASSERT_TRUE(map.insertObservation(scanOf(Room{-15, 15, -15, 15, 2.5}, CPose3D()), CPose3D()));
  EXPECT_EQ(map.getVoroniClearance(3, 3), 0);
  EXPECT_EQ(map.getBasisCell(3, 3), 0);
}

TEST(CScanShapeGridMap2D, ADriveSeldomCopiesTheGrid)
{
  auto map = mapForRooms();
  map.scanInsertionOptions.profile.maxRange = 4;
  int changes = 0;
  const Room corridor{-100, 100, -2, 2, 2.5};
  for (int i = 0; i < 100; ++i)
  {
    const CPose3D robot(0.4 * i, 0, 0);
    const grid::GridFrame before = map.frame();
    ASSERT_TRUE(map.insertObservation(scanOf(corridor, robot), robot));
    changes += map.frame() == before ? 0 : 1;
  }
  EXPECT_LE(changes, 15);
  EXPECT_GE(changes, 2);
}

TEST(CScanShapeGridMap2D, AFirstScanFarAwayDoesNotReachBackToTheOrigin)
{
  const Room room{997, 1003, 498, 502, 2.5};
  const CPose3D robot(1000, 500, 0);
  auto map = mapForRooms();
  ASSERT_TRUE(map.insertObservation(scanOf(room, robot), robot));
  EXPECT_GT(map.getXMin(), 980);
  EXPECT_LT(map.getSizeX(), 200u);
}

TEST(CScanShapeGridMap2D, AGridChangedThroughTheBaseClassIsWhatTheNextScanIsInsertedInto)
{
  const Room room, larger{-4, 4, -4, 4, 2.5};
  auto map = mapOf(room), twin = map;
  map.resizeGrid(-50, 50, -50, 50);
  ASSERT_TRUE(map.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
  ASSERT_TRUE(twin.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
  EXPECT_NE(map.getSizeX(), twin.getSizeX());
  expectSameCells(map, twin);

  map.setSize(-10, 10, -10, 10, 0.25f);  // erased, and coarser
  auto coarse = mapForRooms(0.25);
  EXPECT_EQ(map.frame().resolution, 0.25);
  ASSERT_TRUE(map.insertObservation(scanOf(room, CPose3D()), CPose3D()));
  ASSERT_TRUE(coarse.insertObservation(scanOf(room, CPose3D()), CPose3D()));
  expectSameCells(map, coarse);

  auto written = mapForRooms();  // a cell that somebody sets before the first scan stays
  written.setPos(-0.95f, -0.95f, 0.1f);
  const Room aside{10, 14, 10, 14, 2.5};
  const CPose3D robot(12, 12, 0);
  ASSERT_TRUE(written.insertObservation(scanOf(aside, robot), robot));
  EXPECT_NEAR(written.getPos(-0.95f, -0.95f), 0.1f, 0.01f);
  EXPECT_GT(written.getPos(12.55f, 12.55f), 0.5f);
}

TEST(CScanShapeGridMap2D, AGridOfAnOddResolutionResizedBehindItsBackStaysOnItsKeys)
{
  for (const double resolution : {0.07, 1.0 / 3, 0.1234567})
  {
    SCOPED_TRACE(resolution);
    const Room room, larger{-15, 15, -16, 16, 2.5};
    auto map = mapOf(room, resolution), twin = map;
    map.resizeGrid(-13.3f, 11.1f, -9.7f, 12.9f);
    ASSERT_TRUE(map.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
    ASSERT_TRUE(twin.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
    expectSameCells(map, twin);
  }
}
