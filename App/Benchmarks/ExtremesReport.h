#ifndef Varimarch_Benchmarks_ExtremesReport_h
#define Varimarch_Benchmarks_ExtremesReport_h

#include "ExtremesBench.h"
#include "Machine.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The measurements of `varimarch-bench extremes`, and how they were made.
struct ExtremesPage
{
  std::string commandText;
  Machine machine; ///< state of the machine before the start
  std::vector<ExtremeMeasurement> measurements;
};

/// A summary of each mapper, and a table of errors and times of all scenes.
std::string ExtremesMarkdown(const ExtremesPage& page);

/// A row for each scene and mapper.
std::string ExtremesCsv(const ExtremesPage& page);

}

#endif
