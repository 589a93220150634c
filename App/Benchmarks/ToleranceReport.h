#ifndef Varimarch_Benchmarks_ToleranceReport_h
#define Varimarch_Benchmarks_ToleranceReport_h

#include "WorkPrecision.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The error and the time of our defaults at one error tolerance, compared with our fastest
/// hand-chosen setting of the same error. Our defaults promise that 99.9 % of the pixels are within
/// the tolerance, all within twice as much, in at most twice the time.

struct ToleranceRow
{
  std::string label;
  double tolerance;             ///< error tolerance, [0, 1]
  double percentile999;         ///< measured 99.9th percentile / tolerance; kept if <= 1
  double largest;               ///< measured largest error / tolerance; kept if <= 2
  double estimate;              ///< the mapper's estimate of the 99.9th percentile / tolerance
  double milliseconds;          ///< time of a still view, without the tolerance search
  std::string handMethod;       ///< fastest method at the measured 99.9th percentile
  std::optional<double> handMs; ///< its time; empty if none of our settings was as precise
};

/// The tolerance of a point; empty if it has a sample distance instead.
std::optional<double> ToleranceOf(const WorkPoint& point);

/// One row per tolerance; none if the method "tolerance" was not measured.
std::vector<ToleranceRow> ToleranceRows(const WorkPrecision& scene);

/// The headings, cells and closing paragraph of a table in a report.
std::vector<std::string> ToleranceHeadings();
std::vector<std::string> ToleranceCells(const ToleranceRow& row);
std::string ToleranceExplanation();

/// The rows of all scenes in aligned columns, for a terminal; empty if there are none.
std::string ToleranceText(const std::vector<WorkPrecision>& scenes);

nlohmann::ordered_json ToJson(const ToleranceRow& row);

}

#endif
