#include "ShaderCost.h"

#include "BenchMethods.h"
#include "Benchmark.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/ReportedErrors.h"
#include "CommandLine/SceneArguments.h"
#include "CommandLine/Truth.h"
#include "FeatureView.h"
#include "Scene/Images/OffscreenView.h"
#include "VtkVersions.h"

#include <vtkCallbackCommand.h>
#include <vtkShaderProgram.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Sends the standard error to a file for the lifetime of this object.
class RedirectedErrors
{
public:
  explicit RedirectedErrors(std::FILE* file)
  {
    std::fflush(stderr);
    dup2(fileno(file), STDERR_FILENO);
  }

  ~RedirectedErrors()
  {
    std::fflush(stderr);
    dup2(this->before, STDERR_FILENO);
    close(this->before);
  }

private:
  int before = dup(STDERR_FILENO);
};

/// The cost of a recipe's shader, without light and with it.
struct ShaderCost
{
  std::string recipe;
  std::optional<ProgramCost> plain; ///< empty if the recipe is always lit
  std::optional<ProgramCost> lit;   ///< empty if the recipe is never lit
};

bool IsSampler(GLenum type)
{
  return type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_BUFFER;
}

int NumbersIn(GLenum type)
{
  static const std::map<GLenum, int> numbers = { { GL_FLOAT_VEC2, 2 }, { GL_FLOAT_VEC3, 3 },
    { GL_FLOAT_VEC4, 4 }, { GL_INT_VEC2, 2 }, { GL_FLOAT_MAT3, 9 }, { GL_FLOAT_MAT4, 16 } };
  const auto found = numbers.find(type);
  return found == numbers.end() ? 1 : found->second;
}

// The uniforms that a program uses are active, those in blocks all of them; so numbers of blocks
// are those that are declared.
ProgramCost CostOf(GLuint program)
{
  ProgramCost cost;
  GLint count = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (GLint uniform = 0; uniform < count; ++uniform)
  {
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program, GLuint(uniform), 0, nullptr, &size, &type, nullptr);
    (IsSampler(type) ? cost.textures : cost.numbers) +=
      IsSampler(type) ? 1 : size * NumbersIn(type);
  }
  if (glGetProgramBinary != nullptr)
  {
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &cost.binaryBytes);
  }
  return cost;
}

/// Learns the cost of the programs that march rays for a mapper.
class ProgramListener
{
public:
  explicit ProgramListener(vtkVolumeMapper* mapper)
  {
    this->command->SetClientData(this);
    this->command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* program)
      {
        static_cast<ProgramListener*>(self)->cost =
          CostOf(GLuint(static_cast<vtkShaderProgram*>(program)->GetHandle()));
      });
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->command);
  }

  ProgramCost CostAfter(const std::function<void()>& draw)
  {
    const std::string printed = ErrorsDuring(draw);
    ThrowIfVtkReportedError();
    CountInstructions(printed, this->cost);
    return this->cost;
  }

private:
  vtkNew<vtkCallbackCommand> command;
  ProgramCost cost;
};

ProgramCost CostOfMethod(const BenchRun& run, const Scene& scene, vtkImageData* image)
{
  MethodView view(run.method, scene, image);
  view.SetOptions(run.settings.front().options);
  ProgramListener listener(view.Offscreen().Pipeline().Mapper());
  return listener.CostAfter([&] { view.Offscreen().Render(); });
}

bool MarchesByOurShaders(const BenchMethod& method)
{
  return method.kind == MapperKind::VarimarchShaders && !method.comparison;
}

std::vector<ShaderCost> CostsOfMethods(Scene scene, vtkImageData* image, const OnStep& onStep)
{
  std::vector<ShaderCost> costs;
  for (const bool lit : { false, true })
  {
    scene.look.shading.enabled = lit;
    for (const BenchRun& run : WorkPrecisionRuns(scene, image, {}))
    {
      if (!MarchesByOurShaders(run.method))
      {
        continue;
      }
      onStep(run.method.name);
      const auto known = std::find_if(costs.begin(), costs.end(),
        [&](const ShaderCost& other) { return other.recipe == run.method.name; });
      ShaderCost& cost =
        known == costs.end() ? costs.emplace_back(ShaderCost{ run.method.name, {}, {} }) : *known;
      (lit ? cost.lit : cost.plain) = CostOfMethod(run, scene, image);
    }
  }
  return costs;
}

// A window for each program: Mesa prints only what it has not compiled before.
ProgramCost CostOfFeature(const Feature& feature, bool lit, const Scene& scene, vtkImageData* image)
{
  const auto adapter = vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New();
  adapter->GetVariationFieldMapper()->ProcessorMarchingOff();
  FeatureView view(scene, image, adapter);
  feature.prepare(view.Stage());
  feature.switchOn(view.Stage());
  view.Stage().volume->GetProperty()->SetShade(lit);
  ProgramListener listener(adapter);
  return listener.CostAfter([&] { view.Render(); });
}

// True if a feature is light itself, or the same as another one with light.
bool IsOfLight(const std::string& name)
{
  return name == "shading" || name.find("-shaded") != std::string::npos;
}

// Asks Mesa, if it is the driver, to print the shaders that it compiles. It must be called before
// there is any OpenGL.
void LetMesaPrintShaders()
{
  setenv("ST_DEBUG", "tgsi", 1); // its name for the last form before the driver's
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

// The costs of the methods of the benchmarks that march rays by shaders, and of all features.
// Nothing is timed.
std::vector<ShaderCost> CostsOfShaders(
  const Scene& scene, vtkImageData* image, const OnStep& onStep)
{
  std::vector<ShaderCost> costs = CostsOfMethods(scene, image, onStep);
  for (const Feature& feature : Features())
  {
    if (!IsOfLight(feature.name))
    {
      onStep(feature.name);
      costs.push_back({ feature.name, CostOfFeature(feature, false, scene, image),
        CostOfFeature(feature, true, scene, image) });
    }
  }
  return costs;
}

nlohmann::ordered_json ToJson(const ProgramCost& cost)
{
  nlohmann::ordered_json json = { { "numbers", cost.numbers }, { "textures", cost.textures },
    { "binaryBytes", cost.binaryBytes } };
  if (cost.printed)
  {
    json["instructions"] = cost.printed->instructions;
    json["fetches"] = cost.printed->fetches;
    json["inputs"] = cost.printed->inputs;
  }
  return json;
}

nlohmann::ordered_json ToJson(const std::vector<ShaderCost>& costs)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ShaderCost& cost : costs)
  {
    json.push_back({ { "recipe", cost.recipe } });
    if (cost.plain)
    {
      json.back()["plain"] = ToJson(*cost.plain);
    }
    if (cost.lit)
    {
      json.back()["lit"] = ToJson(*cost.lit);
    }
  }
  return json;
}

struct ShaderOptions
{
  SceneArguments scene;
  std::string input;
};

void AddShaderOptions(CLI::App& command, ShaderOptions& options)
{
  AddSceneArgument(command, options.input);
  AddLookAndPictureOptions(command, options.scene);
}

void RunShaderCosts(const ShaderOptions& options, BenchResults& results)
{
  LetMesaPrintShaders();
  const auto [scene, volume] = LoadScene(options.scene, options.input);
  Progress progress("Compiling shaders");
  const std::vector<ShaderCost> costs = CostsOfShaders(
    scene, volume.image, [&](const std::string& step) { progress.SetActivity(step); });
  results.json["openglRenderer"] =
    OffscreenView(scene, volume.image, MapperKind::VarimarchShaders).DeviceName();
  results.json["shaders"] = ToJson(costs);
  results.Write("all shaders");
}

}

Benchmark ShaderBenchmark()
{
  return MakeBenchmark("shaders", "Ask the driver for the cost of each shader, unlit and lit",
    "Mesa's drivers also tell the instructions.\n"
    "Example:\n"
    "  varimarch-bench shaders procedural:torso:32x32x24 -o report",
    AddShaderOptions, RunShaderCosts);
}

std::string ErrorsDuring(const std::function<void()>& act)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  if (!file)
  {
    throw std::runtime_error("Cannot make a temporary file for what the driver prints: look for "
                             "space in the folder of temporary files");
  }
  {
    const RedirectedErrors redirected(file.get());
    act();
  }
  std::fseek(file.get(), 0, SEEK_END);
  std::string text(std::size_t(std::ftell(file.get())), '\0');
  std::rewind(file.get());
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  return text;
}

void CountInstructions(const std::string& printed, ProgramCost& cost)
{
  static const std::regex instruction(R"(^\s+(vec\d+ +\d+ ssa_\d+ = |intrinsic ))");
  static const std::regex address(R"( = (deref_\w+|load_const|undefined|phi)\b)");
  static const std::regex fetch(R"(\)(tex|txl|txf|txb) )");
  std::istringstream lines(printed);
  bool isFragment = false;
  PrintedShader counted;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("shader: ", 0) == 0)
    {
      isFragment = line == "shader: MESA_SHADER_FRAGMENT";
      counted = {};
    }
    if (line.rfind("inputs: ", 0) == 0)
    {
      counted.inputs = std::stoi(line.substr(8));
    }
    if (isFragment && std::regex_search(line, instruction) && !std::regex_search(line, address))
    {
      ++counted.instructions;
      counted.fetches += std::regex_search(line, fetch);
    }
    if (!cost.printed || counted.instructions > cost.printed->instructions)
    {
      cost.printed = counted;
    }
  }
}

}
