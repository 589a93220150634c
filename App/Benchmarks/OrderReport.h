#ifndef Varimarch_Benchmarks_OrderReport_h
#define Varimarch_Benchmarks_OrderReport_h

#include "Machine.h"
#include "OrderBench.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// The measurements of `varimarch-bench order`, and how they were made.
struct OrderPage
{
  std::string commandText;
  Machine machine; ///< state of the machine before the start
  int side;        ///< height and width of the images [pixels]
  std::vector<OrderExperiment> experiments;
};

std::string OrderMarkdown(const OrderPage& page);

/// All errors, a row for each method and width.
std::string OrderCsv(const OrderPage& page);

nlohmann::ordered_json ToJson(const OrderPage& page);

LogLogPlot OrderPlot(const OrderExperiment& experiment);

}

#endif
