#ifndef Varimarch_Benchmarks_ToleranceReport_h
#define Varimarch_Benchmarks_ToleranceReport_h

#include "WorkPrecision.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// How well our defaults keep an error tolerance, and at what price: a row per tolerance, beside
/// our fastest hand-chosen setting with the same error. The promises: 99.9 % of the pixels within
/// the tolerance, all within twice as much, in at most twice the time.

struct ToleranceRow
{
  std::string label;
  double tolerance;     ///< of 1
  double percentile999; ///< measured, as a fraction of the tolerance; kept: <= 1
  double largest;       ///< measured, as a fraction of the tolerance; kept: <= 2
  double estimate;      ///< the mapper's, of the 99.9th percentile, as a fraction of the tolerance
  double milliseconds;  ///< of a still view, after the search for a sample distance has ended
  std::string handMethod;       ///< the fastest method at the measured 99.9th percentile
  std::optional<double> handMs; ///< its time; empty: none of our settings was as precise
};

/// The tolerance of a point; empty where a sample distance was given.
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
