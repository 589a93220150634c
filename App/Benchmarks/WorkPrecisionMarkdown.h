#ifndef Varimarch_Benchmarks_WorkPrecisionMarkdown_h
#define Varimarch_Benchmarks_WorkPrecisionMarkdown_h

#include "WorkPrecisionHtml.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Work-precision measurements as the tables of a report: speed against VTK's GPU mapper at equal
/// error, whether our curve is left of and below its one, and how error tolerances are kept. Links
/// lead to the plots beside it.
std::string WorkPrecisionMarkdown(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page);

}

#endif
