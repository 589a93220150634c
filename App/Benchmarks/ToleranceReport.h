#ifndef Varimarch_Benchmarks_ToleranceReport_h
#define Varimarch_Benchmarks_ToleranceReport_h

#include "WorkPrecision.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// How well our defaults keep an error tolerance, and whether they waste time on it: a row per
/// tolerance, with the fastest of our settings by hand that errs as much. The promises: 99.9 % of
/// the pixels within the tolerance, all within twice as much, in at most twice the time.

struct ToleranceRow
{
  std::string label;
  double tolerance;       ///< of 1
  double percentile999;   ///< measured, as a part of the tolerance; kept: <= 1
  double largest;         ///< measured, as a part of the tolerance; kept: <= 2
  double estimate;        ///< the mapper's, of the 99.9th percentile, as a part of the tolerance
  double milliseconds;    ///< of a still view, in which nothing is tried out any more
  std::string handMethod; ///< the fastest at that measured 99.9th percentile
  std::optional<double> handMs; ///< its time; empty: none of our settings was so precise
};

/// The tolerance that a point's picture was to keep; empty where a sample distance was given.
std::optional<double> ToleranceOf(const WorkPoint& point);

/// None when the method "tolerance" was not measured.
std::vector<ToleranceRow> ToleranceRows(const WorkPrecision& scene);

/// A table's headings, cells and last paragraph, for people.
std::vector<std::string> ToleranceHeadings();
std::vector<std::string> ToleranceCells(const ToleranceRow& row);
std::string ToleranceExplanation();

/// The rows of all scenes in line, for a terminal; empty when there are none.
std::string ToleranceText(const std::vector<WorkPrecision>& scenes);

nlohmann::ordered_json ToJson(const ToleranceRow& row);

}

#endif
