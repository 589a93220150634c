// A target for each format of looks.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

const LookContext Context = { -1000.0, 3000.0, 1.5, { { 100.0, 0.0 }, { 500.0, 1.0 } } };

struct LookRow
{
  const char* extension;
  std::function<std::vector<std::string>()> seeds;
  std::vector<std::string> words;
};

/// The built-in presets as files of a format that can be written.
std::vector<std::string> Written(const std::string& extension)
{
  std::vector<std::string> seeds;
  const TemporaryFolder folder;
  for (const char* const name : { "ct-bone", "ct-vessels" })
  {
    WriteLookFile(BuiltInPreset(name), folder.Path("a" + extension), Context);
    seeds.push_back(folder.Bytes("a" + extension));
  }
  return seeds;
}

std::vector<std::string> MrmlSeeds()
{
  return {
    "<MRML version=\"Slicer4\"><VolumeProperty name=\"CT-AAA\" gradientOpacity=\"4 0 1 255 1\" "
    "specularPower=\"10\" scalarOpacity=\"6 -3024 0 143.5 0.5 3071 0.75\" specular=\"0.25\" "
    "shade=\"1\" ambient=\"0.1\" colorTransfer=\"8 -3024 0 0 0 3071 1 0.5 0.25\" "
    "diffuse=\"0.9\" interpolation=\"1\"></VolumeProperty></MRML>"
  };
}

std::vector<std::string> CtblSeeds()
{
  return { "# Color table file\n0 Background 0 0 0 0\n2 Liver 221 130 101 255\n" };
}

std::vector<std::string> LabelSeeds()
{
  return { "# IDX -R- -G- -B- -A-- VIS MSH LABEL\n0 0 0 0 0 0 0 \"Clear Label\"\n"
           "2 221 130 101 1 1 1 \"Liver, left\"\n" };
}

std::vector<std::string> ClutSeeds()
{
  return {
    "[FLT]\r\nmin=180\r\nmax=690\r\n[INT]\r\nnumnodes=2\r\n[BYT]\r\nnodeintensity0=0\r\n"
    "nodeintensity1=255\r\n[RGBA255]\r\nnodergba0=0|0|0|0\r\nnodergba1=255|250|245|160\r\n"
  };
}

std::vector<std::string> PlistSeeds()
{
  const std::string color = "<dict><key>red</key><real>0.25</real><key>green</key>"
                            "<real>0.5</real><key>blue</key><integer>1</integer></dict>";
  const std::string point = "<dict><key>x</key><real>-50</real><key>y</key><real>0</real></dict>";
  return { "<?xml version=\"1.0\"?><plist version=\"1.0\"><dict><key>16bitClutColors</key><array>"
           "<array>" +
    color + color + "</array></array><key>16bitClutCurves</key><array><array>" + point + point +
    "</array></array><key>useShading</key><false/></dict></plist>" };
}

std::vector<std::string> ItfSeeds()
{
  return { "<?xml version=\"1.0\" ?><InviwoWorkspace version=\"3\"><maskMin content=\"0.25\" />"
           "<maskMax content=\"1\" /><type content=\"0\" /><Points><Point><pos content=\"0.5\" />"
           "<rgba x=\"1\" y=\"0\" z=\"0\" w=\"0.5\" /></Point></Points></InviwoWorkspace>",
    "<?xml version=\"1.0\" ?><InviwoTreeData version=\"1.0\"><dataPoints><point>"
    "<pos x=\"0.5\" y=\"0.75\" /><rgba x=\"1\" y=\"0\" z=\"0\" w=\"0.75\" /></point></dataPoints>"
    "</InviwoTreeData>" };
}

std::vector<std::string> LutSeeds()
{
  std::string bytes(768, 'c');
  return { bytes, "ICOL" + std::string(28, '\0') + bytes,
    "Index Red Green Blue\n0 1 2 3\n1 4 5 6\n255 7 8 9\n" };
}

std::vector<LookRow> LookRows()
{
  return {
    { ".json", [] { return Written(".json"); },
      { "\"colors\"", "\"opacities\"", "\"value\"", "\"rgb\"", "\"midpoint\"", "\"sharpness\"",
        "\"shading\"", "\"errorTolerance\"", "\"background\"", "\"isosurfaces\"", "1e308" } },
    { ".vp.json", [] { return Written(".vp.json"); },
      { "\"volumeProperties\"", "\"effectiveRange\"", "\"components\"", "\"scalarOpacity\"",
        "\"points\"", "\"x\"", "\"y\"", "\"color\"", "\"lighting\"", "\"isVisible\"" } },
    { ".vp", [] { return Written(".vp"); }, { "1e308", "nan", "inf", "-1" } },
    { ".mrml", MrmlSeeds,
      { "<MRML", "<VolumeProperty", "scalarOpacity=\"", "colorTransfer=\"", "gradientOpacity=\"",
        "1e308", "nan", "&#10;", "<!DOCTYPE", "<!ENTITY" } },
    { ".ctbl", CtblSeeds, { "# ", "nan", "1e308", "-1" } },
    { ".paraview.json", [] { return Written(".paraview.json"); },
      { "\"ColorSpace\"", "\"RGB\"", "\"Lab\"", "\"HSV\"", "\"Diverging\"", "\"Points\"",
        "\"RGBPoints\"", "\"Name\"", "\"NanColor\"", "\"Step\"" } },
    { ".clut", ClutSeeds,
      { "[FLT]", "min=", "max=", "[INT]", "numnodes=", "[BYT]", "nodeintensity1=", "[RGBA255]",
        "nodergba1=", "|" } },
    { ".plist", PlistSeeds,
      { "bplist00", "<key>16bitClutColors</key>", "<key>16bitClutCurves</key>", "<array>", "<dict>",
        "<real>", "<data>", "<!ENTITY", "<key>CLUT</key>" } },
    { ".itf", ItfSeeds,
      { "<Points>", "<Point>", "<pos content=\"", "<rgba x=\"", "<maskMin content=\"",
        "<type content=\"1\"", "1e308", "<!ENTITY" } },
    { ".lut", LutSeeds, { "ICOL", "Index Red Green Blue", "nan" } },
    { ".label", LabelSeeds, { "# ", "\"", "1e308" } },
  };
}

/// Requires that a look can be drawn, and reads back as a preset of ours.
void RequireUsable(const Preset& preset)
{
  const Look& look = preset.look;
  Require(!look.colors.empty() && !look.opacities.empty(), "a look has no colours or no opacities");
  const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
  const TransferFunction gradients({}, look.gradientOpacities, 1.0);
  const std::string text = PresetText(preset);
  Require(PresetText(PresetFromText(text, "a.json")) == text, "a look reads back otherwise");
}

/// The looks of a file; none if it is refused, in one line that names it.
std::vector<Preset> LooksOrRefusal(const std::string& name)
{
  try
  {
    const std::vector<Preset> presets = ReadLookFile(Inputs().Path(name), Context);
    Require(!presets.empty(), "a file was read without a look");
    return presets;
  }
  catch (const std::runtime_error& error)
  {
    RequireOneLine(error.what());
    Require(std::string(error.what()).find(name) != std::string::npos,
      "the error does not name the file: " + std::string(error.what()));
    return {};
  }
}

bool ReadLooks(const std::string& name, const std::string& input)
{
  Inputs().Replace({ name }, input);
  const std::vector<Preset> presets = LooksOrRefusal(name);
  std::for_each(presets.begin(), presets.end(), RequireUsable);
  return !presets.empty();
}

}

std::vector<FuzzTarget> LookTargets()
{
  std::vector<FuzzTarget> targets;
  for (const LookRow& row : LookRows())
  {
    const std::string name = std::string("a") + row.extension;
    targets.push_back({ "look" + std::string(row.extension),
      [name](const std::string& input) { return ReadLooks(name, input); }, row.seeds, row.words });
  }
  return targets;
}

}
