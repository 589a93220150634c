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
  std::vector<std::vector<std::string>> plotSvgs; ///< plots of each scene as SVG texts
};

/// Work-precision measurements as a self-contained HTML file: plots, tables, images and their
/// differences from the truth.
std::string WorkPrecisionHtml(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page);

}

#endif
