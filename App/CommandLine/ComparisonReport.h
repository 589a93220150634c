#ifndef Varimarch_CommandLine_ComparisonReport_h
#define Varimarch_CommandLine_ComparisonReport_h

#include "Comparison.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

// Reports of a comparison as text, Markdown, CSV and JSON. Errors are in 1/255 of premultiplied
// RGBA before the background.

/// A table in aligned columns for a terminal, with a sentence about the measurement.
std::string TableText(const Comparison& comparison);

/// The table as Markdown, with the command that made it.
std::string TableMarkdown(const Comparison& comparison, const std::string& commandText);

/// A CSV table with a header line and a line per renderer.
std::string TableCsv(const Comparison& comparison);

/// All measurements as JSON.
nlohmann::ordered_json ToJson(const Comparison& comparison);

/// The speed-up over VTK's GPU mapper.
double RatioToVtkGpu(const Comparison& comparison, const Measurement& measurement);

/// The class name of a mapper.
std::string ClassName(MapperKind kind);

}

#endif
