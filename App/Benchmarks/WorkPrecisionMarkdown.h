#ifndef Varimarch_Benchmarks_WorkPrecisionMarkdown_h
#define Varimarch_Benchmarks_WorkPrecisionMarkdown_h

#include "WorkPrecisionHtml.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Work-precision measurements as Markdown tables: speed-ups over VTK's GPU mapper at equal error,
/// a verdict on whether our curve lies left of and below VTK's, and errors as fractions of the
/// error tolerance. Links lead to the plots in the same folder.
std::string WorkPrecisionMarkdown(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page);

}

#endif
