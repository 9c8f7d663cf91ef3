#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/PictureColors.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>

#include "support/TempDir.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;
using mrpt::img::CImage;

namespace
{
const float kNan = std::numeric_limits<float>::quiet_NaN();
using Rgb = std::array<int, 3>;
const Rgb kFreeRgb{255, 255, 255}, kOccupiedRgb{32, 38, 46}, kUnknownRgb{199, 203, 209};
const Rgb kSteepRgb{232, 131, 46}, kNoDataRgb{222, 224, 227};

/** How many pixels have which colour. */
std::map<Rgb, std::size_t> colors(const CImage& image)
{
  std::map<Rgb, std::size_t> count;
  for (unsigned y = 0; y < image.getHeight(); ++y)
  {
    const auto* bgr = image.ptrLine<std::uint8_t>(y);
    for (unsigned x = 0; x < image.getWidth(); ++x, bgr += 3) ++count[{bgr[2], bgr[1], bgr[0]}];
  }
  return count;
}

/** The mean row of the pixels of a colour, counted from the top. */
double meanRow(const CImage& image, const Rgb& color)
{
  double sum = 0, count = 0;
  for (unsigned y = 0; y < image.getHeight(); ++y)
  {
    const auto* bgr = image.ptrLine<std::uint8_t>(y);
    for (unsigned x = 0; x < image.getWidth(); ++x, bgr += 3)
      if (Rgb{bgr[2], bgr[1], bgr[0]} == color)
      {
        sum += y;
        ++count;
      }
  }
  return sum / count;
}

const StyledLayer kOccupancy{"aerial", nullptr, "Occupancy", "", LayerKind::Occupancy};
const StyledLayer kHeight{"floor", nullptr, "Floor", "m", LayerKind::Height};
const StyledLayer kSlope{"slope", nullptr, "Slope", "m/m", LayerKind::Slope};

StyledLayer styled(const Layer<float>& layer, StyledLayer style,
                   const Layer<float>* freeFor = nullptr)
{
  style.layer = &layer;
  style.freeFor = freeFor;
  return style;
}
}  // namespace

TEST(LayerPicture, smallMapsAreEnlargedCellByCell)
{
  Layer<float> layer(GridFrame{0.1, 0, 0, 60, 40}, kFree);
  layer.at(3, 35) = 1.0f;
  const CImage without = drawLayer(styled(Layer<float>(layer.frame(), kFree), kOccupancy));
  const CImage image = drawLayer(styled(layer, kOccupancy));
  EXPECT_EQ(colors(image)[kOccupiedRgb] - colors(without)[kOccupiedRgb], 14U * 14U);
  EXPECT_GE(image.getWidth(), 840U);
  EXPECT_LE(image.getWidth(), 1100U);
}

TEST(LayerPicture, northIsUp)
{
  Layer<float> layer(GridFrame{0.1, 0, 0, 60, 60}, kFree);
  for (int x = 0; x < 60; ++x) layer.at(x, 55) = 1.0f;
  const CImage image = drawLayer(styled(layer, kOccupancy));
  EXPECT_LT(meanRow(image, kOccupiedRgb), static_cast<double>(image.getHeight()) / 3);
}

TEST(LayerPicture, occupiedWinsInReducedMaps)
{
  Layer<float> layer(GridFrame{0.05, 0, 0, 5000, 90}, kFree);
  for (int x = 0; x < 5000; ++x) layer.at(x, 46) = 0.6f;  // a wall one cell thick
  const CImage image = drawLayer(styled(layer, kOccupancy));
  EXPECT_LE(image.getWidth(), 2400U);
  EXPECT_GE(colors(image)[kOccupiedRgb], 1667U);
}

TEST(LayerPicture, whatWarnsOfTheGroundWinsOverFreeInReducedMaps)
{
  const GridFrame frame{0.05, 0, 0, 5000, 90};
  Layer<float> ground(frame, kFree), evidence(frame, 1);
  const Layer<float> aerial(frame, kFree);
  for (int x = 0; x < 5000; ++x)  // lines one cell thick, between free cells
  {
    evidence.at(x, 25) = kInferredGround;
    ground.at(x, 46) = kUnknown;
    evidence.at(x, 58) = kInferredGround;  // beside a frontier
    ground.at(x, 59) = kUnknown;
  }
  StyledLayer style = styled(ground, kOccupancy, &aerial);
  style.evidence = &evidence;
  auto found = colors(drawLayer(style));
  const auto rgb = [](const picture::TColor& c) -> Rgb { return {c.R, c.G, c.B}; };
  EXPECT_GE(found[rgb(picture::kInferredColor)], 1667U);
  EXPECT_GE(found[rgb(picture::kFrontierColor)], 2 * 1667U);
}

TEST(LayerPicture, steepOnlyWithTheAerialLayer)
{
  const GridFrame frame{0.1, 0, 0, 80, 80};
  Layer<float> ground(frame, kFree), aerial(frame, kFree);
  ground.at(5, 5) = 1.0f;
  ground.at(9, 9) = aerial.at(9, 9) = 1.0f;
  EXPECT_EQ(colors(drawLayer(styled(ground, kOccupancy)))[kSteepRgb], 0U);
  EXPECT_GE(colors(drawLayer(styled(ground, kOccupancy, &aerial)))[kSteepRgb], 100U);
  EXPECT_LT(colors(drawLayer(styled(ground, kOccupancy, &aerial)))[kOccupiedRgb],
            colors(drawLayer(styled(ground, kOccupancy)))[kOccupiedRgb]);
}

TEST(LayerPicture, missingValuesAreGrey)
{
  Layer<float> layer(GridFrame{0.1, 0, 0, 80, 80}, kNan);
  for (int x = 0; x < 80; ++x)
    for (int y = 0; y < 40; ++y) layer.at(x, y) = static_cast<float>(x);
  layer.at(0, 79) = 0;  // else the picture would end above the known half
  layer.at(0, 0) = std::numeric_limits<float>::infinity();
  for (const StyledLayer& style : {kHeight, kSlope})
  {
    const std::size_t grey = colors(drawLayer(styled(layer, style)))[kNoDataRgb];
    EXPECT_NEAR(static_cast<double>(grey), 800.0 * 400 + 100, 500) << style.title;
  }
}

TEST(LayerPicture, showsWhatIsKnownAndAMargin)
{
  Layer<float> big(GridFrame{0.1, 0, 0, 1000, 900}, kNan);
  for (int x = 500; x < 560; ++x)
    for (int y = 300; y < 340; ++y) big.at(x, y) = static_cast<float>(x);
  const GridFrame known{0.1, 500, 300, 60, 40}, shown{0.1, 497, 297, 66, 46};
  EXPECT_EQ(knownFrame(big, LayerKind::Height), known);
  EXPECT_EQ(shownFrame({styled(big, kHeight)}), shown);
  const CImage image = drawLayer(styled(big, kHeight));
  EXPECT_NEAR(static_cast<double>(colors(image)[kNoDataRgb]), (66 * 46 - 60 * 40) * 13 * 13, 900)
      << "13 pixels a cell make 66 cells more than 800";
  EXPECT_EQ(colors(drawLayer(styled(big, kHeight), {}, known))[kNoDataRgb],
            colors(drawLayer(styled(big.onFrame(known, kNan), kHeight)))[kNoDataRgb]);

  Layer<float> occupancy(big.frame(), kUnknown);
  EXPECT_EQ(shownFrame({styled(occupancy, kOccupancy)}), big.frame()) << "nothing is known";
  occupancy.at(0, 899) = kFree;  // the margin ends with the map
  occupancy.at(1, 898) = 0.5f;
  EXPECT_EQ(knownFrame(occupancy, LayerKind::Occupancy), (GridFrame{0.1, 0, 898, 2, 2}));
  EXPECT_EQ(shownFrame({styled(occupancy, kOccupancy)}), (GridFrame{0.1, 0, 896, 4, 4}));
  EXPECT_EQ(shownFrame({styled(big, kHeight), styled(occupancy, kOccupancy)}),
            (GridFrame{0.1, 0, 270, 590, 630}))
      << "pictures of one map show the same part";
}

TEST(LayerPicture, aLayerWithoutDataIsStillAPicture)
{
  const Layer<float> layer(GridFrame{0.1, 0, 0, 80, 80}, kNan);
  for (const StyledLayer& style : {kHeight, kSlope, kOccupancy})
  {
    auto count = colors(drawLayer(styled(layer, style)));
    EXPECT_GE(count[style.kind == LayerKind::Occupancy ? kUnknownRgb : kNoDataRgb], 630000U);
  }
}

TEST(LayerPicture, everyShapeAndScaleCanBeDrawn)
{
  std::mt19937 random(3);
  std::normal_distribution<float> value(0, 100);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {7, 2500}, {2500, 7}})
    for (const double resolution : {0.001, 0.07, 25.0})
      for (const StyledLayer& style : {kHeight, kSlope, kOccupancy})
      {
        Layer<float> layer(GridFrame{resolution, -1000000, 1000000, width, height}, 0.0f);
        for (float& cell : layer.cells()) cell = value(random);
        const CImage image = drawLayer(styled(layer, style));
        EXPECT_GE(image.getWidth(), static_cast<unsigned>(std::min(width, 1200)));
        EXPECT_LE(image.getWidth(), 3200U);
      }
}

TEST(LayerPicture, pngReadsBack)
{
  const TempDir dir;
  Layer<float> layer(GridFrame{0.1, 0, 0, 20, 30}, 1.5f);
  writeLayerPng(dir.path("x.png"), styled(layer, kHeight));
  const CImage drawn = drawLayer(styled(layer, kHeight));
  const CImage read = CImage::LoadFromFile(dir.path("x.png"));
  ASSERT_EQ(read.getWidth(), drawn.getWidth());
  ASSERT_EQ(read.getHeight(), drawn.getHeight());
  EXPECT_EQ(colors(read), colors(drawn));
}

TEST(LayerPicture, refusesWhatCannotBeDrawn)
{
  const TempDir dir;
  const Layer<float> a(GridFrame{0.1, 0, 0, 2, 2}, 0), b(GridFrame{0.1, 1, 0, 2, 2}, 0);
  EXPECT_THROW(drawLayer(kHeight), std::invalid_argument);
  const Layer<float> none;
  EXPECT_THROW(drawLayer(styled(none, kHeight)), std::invalid_argument);
  EXPECT_THROW(drawLayer(styled(a, kOccupancy, &b)), std::invalid_argument);
  EXPECT_THROW(writeLayerPng(dir.path("x.bmp"), styled(a, kHeight)), std::invalid_argument);
  EXPECT_EQ(messageOf([&] { writeLayerPng(dir.path("no/x.png"), styled(a, kHeight)); }),
            "cannot write '" + dir.path("no/x.png") + "': No such file or directory");
}

TEST(LayerPicture, noticesFullDisk)
{
  const Layer<float> layer(GridFrame{0.1, 0, 0, 30, 20}, 1.0f);
  for (const int kilobytes : {4, 8, 12})
  {
    const TinyDisk disk(kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "not allowed to mount a small disk";
    const auto message =
        messageOf([&] { writeLayerPng(disk.path("x.png"), styled(layer, kHeight)); });
    EXPECT_TRUE(contains(message, "cannot write '" + disk.path("x.png"))) << message;
  }
}
