#ifndef Varimarch_Benchmarks_WorkPrecisionHtml_h
#define Varimarch_Benchmarks_WorkPrecisionHtml_h

#include "Machine.h"
#include "WorkPrecision.h"

#include <string>
#include <vector>

namespace varimarch
{

struct WorkPrecisionPage
{
  std::string commandText;
  Machine machine;
  std::vector<std::vector<std::string>> plotSvgs; ///< the texts of each scene's plots
};

/// Work-precision measurements as one HTML file that needs no other: plots, tables, pictures and
/// their differences from the truth.
std::string WorkPrecisionHtml(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page);

}

#endif
