#include "ShaderCost.h"

#include "CapturedErrors.h"
#include "CommandLine/VtkMessages.h"
#include "FeatureView.h"
#include "MethodView.h"
#include "VtkVersions.h"

#include <vtkCallbackCommand.h>
#include <vtkShaderProgram.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

namespace varimarch
{

namespace
{

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

}

void LetMesaPrintShaders()
{
  setenv("ST_DEBUG", "tgsi", 1); // its name for the last form before the driver's
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

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
