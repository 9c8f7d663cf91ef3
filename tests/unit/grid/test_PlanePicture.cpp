#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/PictureColors.h>
#include <mrpt_mapconv/grid/PlaneColors.h>

#include <cmath>

using namespace mrpt_mapconv::grid;
using mrpt::img::CImage;
using mrpt::img::TColor;

namespace
{
const GridFrame kFrame{0.1, -4, -4, 8, 8, -0.5};

std::size_t count(const CImage& image, const TColor& color)
{
  std::size_t pixels = 0;
  for (unsigned y = 0; y < image.getHeight(); ++y)
  {
    const auto* bgr = image.ptrLine<std::uint8_t>(y);
    for (unsigned x = 0; x < image.getWidth(); ++x, bgr += 3)
      pixels += TColor(bgr[2], bgr[1], bgr[0]) == color;
  }
  return pixels;
}

/** The left half is a plane of one leaf of 4 x 4 cells above another, the right half cells without
 * a plane, but for an unknown one in the upper right corner. */
struct HalfPlane
{
  Layer<float> plane{kFrame, NAN}, height{kFrame, 1}, squares{kFrame, 0.1f};

  HalfPlane()
  {
    for (std::int32_t y = 0; y < 8; ++y)
      for (std::int32_t x = 0; x < 4; ++x)
      {
        plane.at(x, y) = 0;
        squares.at(x, y) = 0.4f;
      }
    height.at(4, 0) = 0;
    height.at(7, 7) = squares.at(7, 7) = NAN;
  }
  StyledLayer styled() const
  {
    StyledLayer layer{"leaves", &plane, "Leaves", "", LayerKind::Plane};
    layer.shade = &height;
    layer.squares = &squares;
    return layer;
  }
  TColor color() const { return picture::PlaneColors(plane).of(0); }
};
constexpr int kSide = 100;  // pixels a cell: 8 cells are enlarged to 800 pixels
}  // namespace

TEST(PlanePicture, ColoursPlanesAndShadesOtherCells)
{
  const HalfPlane map;
  StyledLayer styled = map.styled();
  styled.squares = nullptr;
  const CImage image = drawLayer(styled, {}, kFrame);
  constexpr double kLegend = 500;  // pixels of a swatch
  EXPECT_NEAR(static_cast<double>(count(image, map.color())), 32.0 * kSide * kSide, kLegend);
  EXPECT_NEAR(static_cast<double>(count(image, picture::bareColor(1))), 30.0 * kSide * kSide,
              kLegend);
  EXPECT_NEAR(static_cast<double>(count(image, picture::bareColor(0))), 1.0 * kSide * kSide,
              kLegend);
  EXPECT_NEAR(static_cast<double>(count(image, picture::kNoDataColor)), 1.0 * kSide * kSide,
              kLegend);
}

TEST(PlanePicture, WithoutHeightsOnlyPlanesShow)
{
  const HalfPlane map;
  StyledLayer styled = map.styled();
  styled.squares = styled.shade = nullptr;
  EXPECT_NEAR(static_cast<double>(count(drawLayer(styled, {}, kFrame), picture::kNoDataColor)),
              32.0 * kSide * kSide, 500);
}

/** Edges are a pixel wide, on the left of and below squares, and where the map ends. */
TEST(PlanePicture, OutlinesSquaresAndNotTheirCells)
{
  const HalfPlane map;
  StyledLayer styled = map.styled(), without = styled;
  without.squares = nullptr;
  const auto outlined = [&](const TColor& color)
  {
    return count(drawLayer(without, {}, kFrame), color) -
           count(drawLayer(styled, {}, kFrame), color);
  };
  // two leaves of 400 pixels, of which one ends the map; corners count once
  EXPECT_EQ(outlined(map.color()), 2u * (400 + 399) + 399);
  // 30 cells of 100 pixels, of which 7 end it on the right and 3 above; two beside the unknown one
  EXPECT_EQ(outlined(picture::bareColor(1)), 30u * (100 + 99) + (7 + 3) * 99 + 2 * 98);
}

TEST(PlanePicture, LeavesOutOutlinesOfWhatIsTooSmall)
{
  Layer<float> plane({0.1, 0, 0, 600, 10}, 0), squares({0.1, 0, 0, 600, 10}, 0.1f);
  StyledLayer styled{"leaves", &plane, "Leaves", "", LayerKind::Plane};
  const auto bare = count(drawLayer(styled), picture::PlaneColors(plane).of(0));
  styled.squares = &squares;  // cells of two pixels
  EXPECT_EQ(count(drawLayer(styled), picture::PlaneColors(plane).of(0)), bare);
}

TEST(PlanePicture, RefusesHeightsOnAnotherFrame)
{
  const HalfPlane map;
  const Layer<float> other({0.1, 0, 0, 8, 8}, 0);
  StyledLayer styled = map.styled();
  styled.shade = &other;
  EXPECT_THROW(drawLayer(styled), std::invalid_argument);
  styled = map.styled();
  styled.squares = &other;
  EXPECT_THROW(drawLayer(styled), std::invalid_argument);
}
