#include "Commands.h"

#include "LightMethodsReport.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

void RunLightMethods(const LightCostArguments& arguments)
{
  LightMethodsPage page{ LightRunOf(arguments), {} };
  SceneBySceneBench bench;
  bench.name = "light-methods";
  bench.measure = [&](const LoadedScene& scene, const OnStep& onStep)
  { page.cases.push_back(MeasureLightMethods(scene, page.run.options, onStep)); };
  bench.json = [&] { return ToJson(page); };
  bench.markdown = [&] { return MarkdownOf(page); };
  bench.csv = [&] { return CsvOf(page); };
  RunSceneByScene(arguments, bench);
}

}
