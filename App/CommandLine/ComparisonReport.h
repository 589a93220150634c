#ifndef Varimarch_CommandLine_ComparisonReport_h
#define Varimarch_CommandLine_ComparisonReport_h

#include "Comparison.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// A comparison's numbers in the forms people and programs read. Errors are in 1/255 of
/// premultiplied RGBA before the background.

/// Columns in line, for a terminal, with a sentence about what was measured.
std::string TableText(const Comparison& comparison);

/// The same as Markdown, with the command that made it.
std::string TableMarkdown(const Comparison& comparison, const std::string& commandText);

/// A heading and a line per renderer.
std::string TableCsv(const Comparison& comparison);

/// All that was measured.
nlohmann::ordered_json ToJson(const Comparison& comparison);

/// Times as fast as VTK's GPU mapper.
double RatioToVtkGpu(const Comparison& comparison, const Measurement& measurement);

/// The class that draws.
std::string ClassName(MapperKind kind);

}

#endif
