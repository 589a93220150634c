// Draws a scene and compares it with its baseline, as the regression tests of VTK's modules do:
// RegressionTests NAME -D DATA -T TEMP -V BASELINE. README.md describes all uses.

#include "Readers/Parsing/VtkMessages.h"
#include "Regression/PictureJudgement.h"
#include "Regression/RegressionCase.h"
#include "Regression/VtkDifferences.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Model/Scene.h"

#include <vtkAbstractVolumeMapper.h>
#include <vtkCallbackCommand.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPNGReader.h>
#include <vtkRegressionTestImage.h>
#include <vtkRendererCollection.h>
#include <vtkTrivialProducer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace
{

// The threshold of vtkRegressionTestImage.
constexpr double VtkThreshold = 0.15;

enum class DrawnBy
{
  Varimarch,
  Shaders,
  Vtk
};

DrawnBy MapperNamed(const std::string& name)
{
  if (name == "shaders")
  {
    return DrawnBy::Shaders;
  }
  if (name == "vtk")
  {
    return DrawnBy::Vtk;
  }
  if (!name.empty())
  {
    throw std::invalid_argument("--mapper " + name + ": expected shaders or vtk");
  }
  return DrawnBy::Varimarch;
}

// Lets VTK's own GPU mapper draw the volumes of a scene, with all settings that both mappers have.
void UseVtkMapper(const RegressionScene& scene)
{
  for (const std::shared_ptr<MapperScene>& volume : scene.volumes)
  {
    volume->UseMapper(varimarch::MapperKind::VtkGpu);
  }
  if (scene.overlap)
  {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    for (int port = 0; port < scene.overlap->mapper->GetNumberOfInputPorts(); ++port)
    {
      if (scene.overlap->mapper->GetNumberOfInputConnections(port) > 0)
      {
        mapper->SetInputDataObject(port, scene.overlap->mapper->GetInputDataObject(port, 0));
      }
    }
    scene.overlap->several->SetMapper(mapper);
  }
}

RegressionCase CaseNamed(const std::string& name)
{
  const std::vector<RegressionCase> cases = AllRegressionCases();
  const auto found = std::find_if(cases.begin(), cases.end(),
    [&](const RegressionCase& regression) { return regression.name == name; });
  if (found == cases.end())
  {
    throw std::invalid_argument(name + ": no such test; --list prints all names");
  }
  return *found;
}

// Draws until images in strips or of several frames are complete.
void RenderAll(const RegressionScene& scene)
{
  bool isComplete = false;
  while (!isComplete)
  {
    scene.Window()->Render();
    isComplete = std::all_of(scene.volumes.begin(), scene.volumes.end(),
      [](const std::shared_ptr<MapperScene>& volume)
      {
        const bool isOurs = volume->volume->GetMapper() == volume->mapper;
        return !isOurs || volume->mapper->GetDrawnPart() >= 1.0;
      });
  }
}

void UseShaders(const RegressionScene& scene)
{
  for (const std::shared_ptr<MapperScene>& volume : scene.volumes)
  {
    volume->UseMapper(varimarch::MapperKind::VarimarchShaders);
  }
  if (scene.overlap)
  {
    scene.overlap->mapper->GetVariationFieldMapper()->ProcessorMarchingOff();
  }
}

void Use(DrawnBy mapper, const RegressionScene& scene)
{
  if (mapper == DrawnBy::Vtk)
  {
    UseVtkMapper(scene);
  }
  if (mapper == DrawnBy::Shaders)
  {
    UseShaders(scene);
  }
}

vtkSmartPointer<vtkImageData> PictureOf(const RegressionScene& scene)
{
  vtkRendererCollection* const renderers = scene.Window()->GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* const renderer = renderers->GetNextItem())
  {
    renderer->SetBackground(scene.background.data());
  }
  RenderAll(scene);
  if (scene.drawn)
  {
    return scene.drawn();
  }
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(scene.Window());
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  return capture->GetOutput();
}

vtkSmartPointer<vtkImageData> TruthOf(const RegressionScene& scene)
{
  return BytesOverBackground(scene.truth(), scene.size, scene.background);
}

vtkSmartPointer<vtkImageData> ImageFrom(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error(
      path + ": not a PNG file; RegressionTests --write FOLDER makes all baselines");
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// Prints pictures and measures in the form that CDash reads, and compares as VTK's own tests do.
bool PassesVtk(vtkTesting* testing, vtkImageData* picture, double threshold)
{
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(picture);
  return testing->RegressionTest(source, threshold) == vtkTesting::PASSED;
}

// Prints the warnings of a mapper, and finds the one that refuses the scene.
bool Refuse(const std::vector<std::string>& warnings, const std::string& refusal)
{
  bool isRefused = false;
  for (const std::string& warning : warnings)
  {
    std::cerr << warning << '\n';
    isRefused = isRefused || warning.find(refusal) != std::string::npos;
  }
  return isRefused;
}

// A mapper that refuses a scene which it draws as it should be would mislead its user.
int JudgeRefused(const std::string& name, const std::string& faults)
{
  std::cerr << name << ": "
            << (faults.empty() ? "The picture that the mapper refuses is right." : faults) << '\n';
  return faults.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

int Judge(const RegressionCase& regression, vtkTesting* testing)
{
  const DrawnBy mapper =
    MapperNamed(std::unique_ptr<char[]>(testing->GetArgument("--mapper")).get());
  varimarch::VtkMessages messages;
  const RegressionScene scene = regression.make();
  Use(mapper, scene);
  if (mapper == DrawnBy::Shaders && !regression.refusal.empty())
  {
    scene.volumes.front()->volume->GetMapper()->AddObserver(
      vtkCommand::WarningEvent, messages.Listener());
  }
  const auto picture = PictureOf(scene);
  const auto baseline = ImageFrom(testing->GetValidImageFileName());
  const bool isVtk = mapper == DrawnBy::Vtk;
  const std::string faults = isVtk
    ? FaultsOfVtk(testing->GetDataRoot(), regression.name, DifferenceOfBytes(picture, baseline))
    : FaultsOf(picture, baseline, regression.allowed999);
  if (Refuse(messages.Warnings(), regression.refusal))
  {
    return JudgeRefused(regression.name, faults);
  }
  // No difference is small enough if our measure found a fault, so that all pictures are printed.
  constexpr double none = -1.0;
  const bool passesVtk =
    (isVtk && faults.empty()) || PassesVtk(testing, picture, faults.empty() ? VtkThreshold : none);
  if (!faults.empty())
  {
    std::cerr << regression.name << ": " << faults << '\n';
  }
  return faults.empty() && passesVtk ? EXIT_SUCCESS : EXIT_FAILURE;
}

int List()
{
  for (const RegressionCase& regression : AllRegressionCases())
  {
    std::cout << regression.name << '\n';
  }
  return EXIT_SUCCESS;
}

int WriteBaselines(const std::string& folder, const std::vector<RegressionCase>& cases)
{
  std::filesystem::create_directories(folder);
  for (const RegressionCase& regression : cases)
  {
    std::cout << regression.name << std::endl;
    varimarch::WritePng(TruthOf(regression.make()), folder + "/" + regression.name + ".png");
  }
  return EXIT_SUCCESS;
}

int WriteVtkDifferences(const std::string& folder)
{
  std::vector<VtkDifference> differences;
  for (const RegressionCase& regression : AllRegressionCases())
  {
    std::cout << regression.name << std::endl;
    const RegressionScene scene = regression.make();
    Use(DrawnBy::Vtk, scene);
    const auto picture = PictureOf(scene);
    const auto baseline = ImageFrom(folder + "/Baseline/" + regression.name + ".png");
    differences.push_back({ regression.name, DifferenceOfBytes(picture, baseline) });
  }
  WriteDifferencesOfVtk(folder, differences);
  return EXIT_SUCCESS;
}

int Run(int argc, char** argv)
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  if (testing->IsFlagSpecified("--list"))
  {
    return List();
  }
  if (testing->IsFlagSpecified("--write"))
  {
    const std::string folder = testing->GetDataRoot();
    const bool isOne = argv[1][0] != '-';
    return testing->IsFlagSpecified("--mapper")
      ? WriteVtkDifferences(folder)
      : WriteBaselines(folder + "/Baseline",
          isOne ? std::vector<RegressionCase>{ CaseNamed(argv[1]) } : AllRegressionCases());
  }
  if (argc < 2 || !testing->IsValidImageSpecified())
  {
    throw std::invalid_argument("expected RegressionTests NAME -D DATA -T TEMP -V BASELINE "
                                "[--mapper shaders|vtk], or --list, or [NAME] --write -D DATA");
  }
  return Judge(CaseNamed(argv[1]), testing);
}

}

int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& problem)
  {
    std::cerr << "RegressionTests: " << problem.what() << '\n';
    return EXIT_FAILURE;
  }
}
