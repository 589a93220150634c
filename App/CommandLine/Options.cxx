#include "Options.h"

#include "Progress.h"
#include "Scene/LookFiles.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"

#include <array>
#include <charconv>
#include <iostream>

namespace varimarch
{

namespace
{

constexpr int LargestPictureSide = 16384;
constexpr int LargestVolumeSide = 1 << 20;
const std::string ProceduralPrefix = "procedural:";

// "640x480" as its numbers; empty when it is not `count` whole numbers within the limits.
template <std::size_t count>
std::optional<std::array<int, count>> Sides(const std::string& text, int smallest, int largest)
{
  std::array<int, count> sides;
  const char* position = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto [next, error] = std::from_chars(position, end, sides[i]);
    const bool last = i + 1 == count;
    if (error != std::errc() || sides[i] < smallest || sides[i] > largest ||
      (last ? next != end : next == end || *next != 'x'))
    {
      return std::nullopt;
    }
    position = next + 1;
  }
  return sides;
}

void RequireItsSurfaces(const Look& look)
{
  if (look.blend == Blend::Isosurface && look.isosurfaces.empty())
  {
    throw CLI::ValidationError("--blend", "isosurface needs a look that has isosurfaces");
  }
}

template <std::size_t count>
CLI::Validator SidesValidator(const std::string& example, int smallest, int largest)
{
  const auto check = [=](std::string& text)
  {
    return Sides<count>(text, smallest, largest)
      ? std::string()
      : "expected a size such as " + example + ", each side from " + std::to_string(smallest) +
        " to " + std::to_string(largest) + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

CLI::Validator Above(double limit)
{
  const auto check = [limit](std::string& text)
  {
    double number = 0.0;
    const bool good = CLI::detail::lexical_cast(text, number) && number > limit &&
      number < std::numeric_limits<double>::infinity();
    return good
      ? std::string()
      : "expected a number > " + CLI::detail::to_string(limit) + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

// "procedural:torso" or "procedural:torso:128x128x64"
ProceduralSource ProceduralFromInput(const std::string& input)
{
  const std::string rest = input.substr(ProceduralPrefix.size());
  const std::size_t colon = rest.find(':');
  const std::string name = rest.substr(0, colon);
  const std::string error = NameValidator(NamesOf(ProceduralNames()))(name);
  if (!error.empty())
  {
    throw CLI::ValidationError("VOLUME", error);
  }
  ProceduralSource source;
  source.kind = ValueOf(ProceduralNames(), name);
  if (colon != std::string::npos)
  {
    const std::string size = rest.substr(colon + 1);
    const auto validator = SidesValidator<3>("128x128x64", 2, LargestProceduralSide);
    const std::string sizeError = validator(size);
    if (!sizeError.empty())
    {
      throw CLI::ValidationError("VOLUME", sizeError);
    }
    source.dimensions = *Sides<3>(size, 2, LargestProceduralSide);
  }
  return source;
}

bool IsSceneFile(const std::string& input)
{
  const std::string extension = ".json";
  return input.size() > extension.size() &&
    input.compare(input.size() - extension.size(), extension.size(), extension) == 0;
}

}

CLI::Validator NameValidator(const std::vector<std::string>& names)
{
  const auto check = [names](std::string& text)
  {
    const bool known = std::find(names.begin(), names.end(), text) != names.end();
    return known ? std::string() : "unknown name \"" + text + "\"; " + Suggestion(text, names);
  };
  return CLI::Validator(check, CLI::detail::join(names, "|"));
}

void VolumeOptions::AddTo(CLI::App& command, const std::string& inputDescription)
{
  command.add_option("VOLUME", this->input, inputDescription)->required();
  const std::string group = "Raw files (no header)";
  CLI::Option* dimensions =
    command.add_option("--raw-dimensions", this->rawDimensions, "Voxels along each axis")
      ->check(SidesValidator<3>("256x256x128", 1, LargestVolumeSide))
      ->type_name("XxYxZ")
      ->group(group);
  command.add_option("--raw-type", this->rawType, "Type of a voxel (default uint8)")
    ->check(NameValidator(NamesOf(RawTypeNames())))
    ->needs(dimensions)
    ->group(group);
  command
    .add_option("--raw-spacing", this->rawSpacing, "Distances of voxels in mm (default 1,1,1)")
    ->check(Above(0.0))
    ->delimiter(',')
    ->expected(3)
    ->type_name("X,Y,Z")
    ->needs(dimensions)
    ->group(group);
  command.add_option("--raw-byte-order", this->rawByteOrder, "Order of bytes (default little)")
    ->check(NameValidator(NamesOf(ByteOrderNames())))
    ->needs(dimensions)
    ->group(group);
}

void VolumeOptions::RefuseRawLayout(const std::string& kind) const
{
  if (!this->rawDimensions.empty())
  {
    throw CLI::ValidationError(
      "--raw-dimensions", "expected a raw file, found the " + kind + " " + this->input);
  }
}

VolumeSource VolumeOptions::SourceOf(const std::string& anyInput) const
{
  if (anyInput.compare(0, ProceduralPrefix.size(), ProceduralPrefix) == 0)
  {
    this->RefuseRawLayout("procedural volume");
    return ProceduralFromInput(anyInput);
  }
  FileSource source = { anyInput, std::nullopt };
  if (!this->rawDimensions.empty())
  {
    RawLayout raw;
    raw.dimensions = *Sides<3>(this->rawDimensions, 1, LargestVolumeSide);
    raw.type = this->rawType.empty() ? raw.type : this->rawType;
    if (!this->rawSpacing.empty())
    {
      std::copy(this->rawSpacing.begin(), this->rawSpacing.end(), raw.spacingMm.begin());
    }
    raw.bigEndian = !this->rawByteOrder.empty() && ValueOf(ByteOrderNames(), this->rawByteOrder);
    source.raw = raw;
  }
  return source;
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
  command.add_option("--background", this->background, "Colour, each from 0 to 1 (default 0,0,0)")
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
      "Largest error accepted in a colour channel, 0 to 1 (default 1/64)")
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("E")
    ->group(group);
  command.add_option("--acceleration", this->acceleration, "What lets our mapper skip samples")
    ->check(NameValidator(NamesOf(AccelerationNames())))
    ->group(group);
  command
    .add_option("--integration", this->integration, "Rule between samples of an unshaded composite")
    ->check(NameValidator(NamesOf(IntegrationNames())))
    ->group(group);
  command
    .add_option("--tolerance", this->tolerance,
      "Largest difference of values it may jump across, in units of the data")
    ->check(CLI::NonNegativeNumber.description(""))
    ->type_name("E")
    ->group(group);
}

std::optional<Look> SceneOptions::ChosenLook(vtkImageData* image) const
{
  if (!this->transferFunction.empty())
  {
    return ReadLookFile(this->transferFunction, ContextOf(image));
  }
  if (!this->preset.empty())
  {
    return Preset(this->preset);
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
    this->volume.RefuseRawLayout("scene file");
  }
  Scene scene = isScene ? ReadScene(input) : Scene();
  if (!isScene)
  {
    scene.volume = this->volume.SourceOf(input);
  }
  LoadedVolume loaded = LoadVolumeReporting(scene.volume);
  if (const std::optional<Look> chosenLook = this->ChosenLook(loaded.image))
  {
    scene.look = *chosenLook;
  }
  else if (!isScene)
  {
    scene.look = Preset(SuggestedPreset(loaded).name);
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
