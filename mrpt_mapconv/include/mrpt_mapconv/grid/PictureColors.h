#pragma once

#include <mrpt/img/TColor.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <algorithm>
#include <array>

namespace mrpt_mapconv::grid::picture
{
using mrpt::img::TColor;

inline const TColor kPaper{255, 255, 255};
inline const TColor kInk{38, 44, 52};
inline const TColor kFaintInk{95, 103, 112};
inline const TColor kNoDataColor{222, 224, 227};

inline const TColor kFreeColor{255, 255, 255};
inline const TColor kOccupiedColor{32, 38, 46};
inline const TColor kUnknownColor{199, 203, 209};
inline const TColor kSteepColor{232, 131, 46};
inline const TColor kInferredColor{200, 226, 244};
inline const TColor kFrontierColor{204, 121, 167};
inline const TColor kDropColor{178, 24, 43};
inline const TColor kPathColor{0, 114, 178};

/** A value of LayerKind::Evidence. */
struct EvidenceLook
{
  TColor color;
  const char* meaning;
};
inline const std::array<EvidenceLook, 5> kEvidenceLooks{
    {{kNoDataColor, "nothing known"},
     {kFreeColor, "ground seen"},
     {kInferredColor, "ground inferred from what was seen around"},
     {kFrontierColor, "ground not seen: it lies at or below what is free"},
     {kOccupiedColor, "something occupied, no free range high enough"}}};

/** Colour of t in [0, 1]: dark blue over green to yellow, of evenly rising lightness, so that it
 * also reads without colour vision and in print (MRPT's jet does not). */
TColor heightColor(double t);
/** Colour of t in [0, 1]: pale yellow (level) over orange to dark red (steep). */
TColor slopeColor(double t);

/** The values that a colour bar spans, and those that there are. */
struct ColorRange
{
  bool empty = true;         //!< no finite value at all
  double low = 0, high = 1;  //!< at the ends of the colour bar
  double dataMin = 0, dataMax = 0;

  bool clippedLow() const { return !empty && dataMin < low; }
  bool clippedHigh() const { return !empty && dataMax > high; }
  /** Where a value lies on the bar, [0, 1]. */
  double position(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0); }
};

/** 0.5th to 99.5th percentile, or everything if the outliers hardly matter. */
ColorRange heightRange(const Layer<float>& layer);
/** 0 to the 98th percentile, or to the largest value if the outliers hardly matter. */
ColorRange slopeRange(const Layer<float>& layer);

}  // namespace mrpt_mapconv::grid::picture
