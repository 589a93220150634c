#include "Options.h"

#include "Progress.h"
#include "Scene/LookFiles.h"
#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"
#include "Validators.h"

#include <iostream>

namespace varimarch
{

namespace
{

constexpr int LargestPictureSide = 16384;

void RequireItsSurfaces(const Look& look)
{
  if (look.blend == Blend::Isosurface && look.isosurfaces.empty())
  {
    throw CLI::ValidationError("--blend", "isosurface needs a look that has isosurfaces");
  }
}

bool IsSceneFile(const std::string& input)
{
  const std::string extension = ".json";
  return input.size() > extension.size() &&
    input.compare(input.size() - extension.size(), extension.size(), extension) == 0;
}

}

void SceneOptions::AddTo(CLI::App& command)
{
  this->volume.AddTo(command,
    "A volume file, a folder with a DICOM series, a scene file (.json), or\n"
    "procedural:shells|marschner-lobb|torso[:XxYxZ]");
  this->AddLookAndPictureTo(command);
  this->AddSamplingOptions(command);
}

void SceneOptions::AddLookAndPictureTo(CLI::App& command)
{
  this->AddLookOptions(command);
  this->AddPictureOptions(command);
}

void SceneOptions::AddLookOptions(CLI::App& command)
{
  const std::string group = "Look";
  CLI::Option* presetOption =
    command
      .add_option("--preset", this->preset, "Look to use (default: ct-bone for CT, else mr-head)")
      ->check(NameValidator(PresetNames()))
      ->group(group);
  command.add_option("--transfer-function", this->transferFunction, "Look from a file")
    ->type_name("FILE")
    ->excludes(presetOption)
    ->group(group);
  CLI::Option* shadeOption = command
                               .add_flag_callback(
                                 "--shade", [this] { this->shade = true; }, "Light the volume")
                               ->group(group);
  command
    .add_flag_callback(
      "--no-shade", [this] { this->shade = false; }, "Do not light it")
    ->excludes(shadeOption)
    ->group(group);
  command.add_option("--blend", this->blend, "How samples become a pixel")
    ->check(NameValidator(NamesOf(BlendNames())))
    ->group(group);
}

void SceneOptions::AddPictureOptions(CLI::App& command)
{
  const std::string group = "Picture";
  command.add_option("--size", this->size, "Pixels (default 512x512)")
    ->check(SidesValidator<2>("800x600", 1, LargestPictureSide))
    ->type_name("WxH")
    ->group(group);
  command.add_option("--view", this->view, "From where to look (default anterior)")
    ->check(NameValidator(NamesOf(ViewNames())))
    ->group(group);
  command.add_option("--azimuth", this->azimuth, "Turn the eye to the patient's left, degrees")
    ->check(CLI::Range(-36000.0, 36000.0).description(""))
    ->group(group);
  command.add_option("--elevation", this->elevation, "Then lift it, degrees from -89 to 89")
    ->check(CLI::Range(-89.0, 89.0).description(""))
    ->group(group);
  command.add_option("--zoom", this->zoom, "At 1 the volume just fits the picture")
    ->check(Above(0.0))
    ->group(group);
  command.add_flag("--parallel", this->parallel, "Parallel instead of perspective projection")
    ->group(group);
  command
    .add_option(
      "--background", this->background, "Colour, each from 0 to 1 (default: the preset's)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->delimiter(',')
    ->expected(3)
    ->type_name("R,G,B")
    ->group(group);
}

void SceneOptions::AddSamplingOptions(CLI::App& command)
{
  const std::string group = "Sampling";
  command
    .add_option(
      "--sample-distance", this->sampleDistance, "Between samples of a ray (default: chosen)")
    ->check(Above(0.0))
    ->type_name("MM")
    ->group(group);
  command
    .add_option("--error-tolerance", this->errorTolerance,
      "Largest error accepted in a colour channel, 0 to 1 (default: the preset's)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("E")
    ->group(group);
  command.add_option("--acceleration", this->acceleration, "What lets our mapper skip samples")
    ->check(NameValidator(NamesOf(AccelerationNames())))
    ->group(group);
  command.add_option("--integration", this->integration, "Rule between samples of a composite")
    ->check(NameValidator(NamesOf(IntegrationNames())))
    ->group(group);
  command
    .add_option("--tolerance", this->tolerance,
      "Largest difference of values it may jump across, in units of the data")
    ->check(CLI::NonNegativeNumber.description(""))
    ->type_name("E")
    ->group(group);
}

std::optional<Preset> SceneOptions::ChosenPreset(vtkImageData* image) const
{
  if (!this->transferFunction.empty())
  {
    return ReadLookFile(this->transferFunction, ContextOf(image));
  }
  if (!this->preset.empty())
  {
    return BuiltInPreset(this->preset);
  }
  return std::nullopt;
}

void SceneOptions::Override(Scene& scene) const
{
  scene.look.shading.enabled = this->shade.value_or(scene.look.shading.enabled);
  scene.camera.azimuthDegrees = this->azimuth.value_or(scene.camera.azimuthDegrees);
  scene.camera.elevationDegrees = this->elevation.value_or(scene.camera.elevationDegrees);
  scene.camera.zoom = this->zoom.value_or(scene.camera.zoom);
  scene.camera.parallel = this->parallel || scene.camera.parallel;
  if (!this->blend.empty())
  {
    scene.look.blend = ValueOf(BlendNames(), this->blend);
    RequireItsSurfaces(scene.look);
  }
  if (!this->size.empty())
  {
    scene.size = *Sides<2>(this->size, 1, LargestPictureSide);
  }
  if (!this->view.empty())
  {
    scene.camera.view = ValueOf(ViewNames(), this->view);
  }
  if (!this->background.empty())
  {
    std::copy(this->background.begin(), this->background.end(), scene.background.begin());
  }
  if (this->sampleDistance)
  {
    scene.render.sampleDistanceMm = this->sampleDistance;
  }
  scene.render.errorTolerance = this->errorTolerance.value_or(scene.render.errorTolerance);
  if (!this->acceleration.empty())
  {
    scene.render.acceleration = ValueOf(AccelerationNames(), this->acceleration);
  }
  if (!this->integration.empty())
  {
    scene.render.integration = ValueOf(IntegrationNames(), this->integration);
  }
  if (this->tolerance)
  {
    scene.render.variationTolerance = this->tolerance;
  }
}

std::pair<Scene, LoadedVolume> SceneOptions::Load(const std::string& input) const
{
  const bool isScene = IsSceneFile(input);
  if (isScene)
  {
    this->volume.RefuseFileOptions("scene file");
  }
  Scene scene = isScene ? ReadScene(input) : Scene();
  scene.volume = isScene ? this->volume.Override(scene.volume) : this->volume.SourceOf(input);
  LoadedVolume loaded = LoadVolumeReporting(scene.volume);
  if (const std::optional<Preset> chosen = this->ChosenPreset(loaded.image))
  {
    TakePreset(*chosen, scene);
  }
  else if (!isScene)
  {
    TakePreset(BuiltInPreset(SuggestedPreset(loaded, ImageStatistics(loaded.image)).name), scene);
  }
  this->Override(scene);
  return { scene, loaded };
}

void AddJsonOption(CLI::App& command, std::string& path)
{
  command.add_option("--json", path, "Write the results there too, for machines")
    ->type_name("FILE");
}

LoadedVolume LoadVolumeReporting(const VolumeSource& source)
{
  const auto* file = std::get_if<FileSource>(&source);
  const Progress progress(file ? "Reading " + file->path : "Computing the volume");
  LoadedVolume volume = LoadVolume(source);
  for (const std::string& warning : volume.warnings)
  {
    std::cerr << "varimarch: warning: " << warning << "\n";
  }
  return volume;
}

void AddOutputOption(CLI::App& command, std::string& folder)
{
  command.add_option("-o,--output", folder, "The folder for the report")
    ->type_name("FOLDER")
    ->required();
}

void AddRoundsOption(CLI::App& command, int& rounds)
{
  command.add_option("--rounds", rounds, "Times to measure each (default 3)")
    ->check(CLI::Range(1, 10000).description(""))
    ->type_name("N");
}
}
