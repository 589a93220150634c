// Other programs' looks, with the irregularities of real files. Files that cannot be read are
// explained in one sentence.

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"

#include <plist/plist.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

using namespace varimarch;

namespace
{

const LookContext Ct = { -1000.0, 3000.0, 1.0, { { 100.0, 0.0 }, { 500.0, 1.0 } } };

class LookFiles : public testing::Test
{
protected:
  LookFiles() { std::filesystem::create_directories(this->folder); }
  ~LookFiles() override { std::filesystem::remove_all(this->folder); }

  std::string Write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(this->folder / name, std::ios::binary) << bytes;
    return (this->folder / name).string();
  }

  Look Read(const std::string& name, const std::string& bytes) const
  {
    return ReadLook(this->Write(name, bytes), "", Ct).look;
  }

  // The error message without the folder.
  std::string ProblemOf(const std::string& name, const std::string& bytes) const
  {
    try
    {
      this->Read(name, bytes);
      return "none";
    }
    catch (const std::runtime_error& problem)
    {
      std::string what = problem.what();
      const std::string path = this->folder.string() + "/";
      const std::size_t at = what.find(path);
      return at == std::string::npos ? what : what.erase(at, path.size());
    }
  }

  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("look-files-" + std::to_string(::getpid()));
};

// The nodes as text: "value:opacity value:opacity ...".
std::string TextOf(const std::vector<OpacityNode>& nodes)
{
  std::string text;
  for (const OpacityNode& node : nodes)
  {
    char one[64];
    std::snprintf(one, sizeof one, "%s%g:%g", text.empty() ? "" : " ", node.value, node.opacity);
    text += one;
  }
  return text;
}

const std::string PlistHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE plist PUBLIC "-//Apple//DTD PLIST 1.0//EN" "http://www.apple.com/DTDs/PropertyList-1.0.dtd">
<plist version="1.0"><dict>)";

std::string PlistColor(double red)
{
  return "<dict><key>red</key><real>" + std::to_string(red) +
    "</real><key>green</key><real>0.5</real><key>blue</key><integer>1</integer></dict>";
}

std::string PlistPoint(double x, double y)
{
  return "<dict><key>x</key><real>" + std::to_string(x) + "</real><key>y</key><real>" +
    std::to_string(y) + "</real></dict>";
}

// Two curves with a gap between them; the second starts abruptly.
const std::string TwoCurves = PlistHead + "<key>16bitClutColors</key><array><array>" +
  PlistColor(0.25) + PlistColor(0.5) + "</array><array>" + PlistColor(0.75) + PlistColor(1.0) +
  "</array></array>" + "<key>16bitClutCurves</key><array><array>" + PlistPoint(-50, 0) +
  PlistPoint(50, 0) + "</array><array>" + PlistPoint(200, 0.5) + PlistPoint(1200, 0.75) +
  "</array></array>" + "<key>useShading</key><false/></dict></plist>";

/// An element in an element, this many times.
std::string Nested(const std::string& element, int levels)
{
  std::string text;
  for (int i = 0; i < 2 * levels; ++i)
  {
    text += (i < levels ? "<" : "</") + element + ">";
  }
  return text;
}

std::string InBinary(const std::string& xml)
{
  plist_t list = nullptr;
  plist_from_xml(xml.data(), std::uint32_t(xml.size()), &list);
  char* bytes = nullptr;
  std::uint32_t size = 0;
  plist_to_bin(list, &bytes, &size);
  const std::string binary(bytes, size);
  std::free(bytes);
  plist_free(list);
  return binary;
}

}

TEST_F(LookFiles, SlicerFilesMayHaveStepsAnUndefinedRangeAndAnyOrder)
{
  const Look look = this->Read("uCT.vp.json", R"({ "@schema": "x", "volumeProperties": [ {
    "effectiveRange": [0, -1], "components": [ {
      "scalarOpacity": { "type": "piecewiseLinearFunction", "points": [
        { "x": 300, "y": 1.5 }, { "x": 200, "y": 0 }, { "x": 200, "y": 1 } ] },
      "gradientOpacity": { "points": [ { "x": 0, "y": 1 }, { "x": 255, "y": 1 } ] },
      "rgbTransferFunction": { "points": [ { "x": 0, "color": [0.5, 2, -1] } ] } } ] } ] })");
  EXPECT_EQ(look.name, "uCT");
  EXPECT_EQ(TextOf(look.opacities), "200:0 200:1 300:1");
  EXPECT_EQ(look.colors[0].rgb, glm::dvec3(0.5, 1.0, 0.0));
  EXPECT_TRUE(look.gradientOpacities.empty()) << "an opacity of 1 everywhere counts as none";
  EXPECT_FALSE(look.shading.enabled) << "Slicer's default";
}

TEST_F(LookFiles, ParaViewFilesMayHaveTrailingCommasAndTheUnitScale)
{
  const Look look = this->Read("map.json", R"([ { "Name": "a, ]", "ColorSpace": "RGB",
    "NanColor": [1, 1, 0,], "Points": [0, 0, 0.5, 0, 1, 0.5, 0.25, 0,],
    "RGBPoints": [0, 1, 0, 0, 1, 0, 0, 1,], }, ])");
  EXPECT_EQ(TextOf(look.opacities), "-1000:0 3000:0.5");
  EXPECT_EQ(look.opacities[1].shape.midpoint, 0.25);
  EXPECT_EQ(look.colors[1].value, 3000.0);
  EXPECT_EQ(look.colors[1].rgb, glm::dvec3(0.0, 0.0, 1.0));
}

TEST_F(LookFiles, ParaViewFilesInUnitsOfTheDataKeepTheirValues)
{
  const Look look = this->Read("map.json",
    R"({ "Points": [10, 0, 0.5, 0, 90, 0.5, 0.5, 0], "RGBPoints": [10, 1, 0, 0, 90, 0, 0, 1] })");
  EXPECT_EQ(TextOf(look.opacities), "10:0 90:0.5");
}

TEST_F(LookFiles, FilesWithOnlyColoursKeepTheOpacities)
{
  const Look look = this->Read(
    "map.json", R"([ { "RGBPoints": [-1, 1, 0, 0, 1, 0, 0, 1], "ColorSpace": "RGB" } ])");
  EXPECT_EQ(TextOf(look.opacities), TextOf(Ct.opacities));
  EXPECT_EQ(look.colors.front().value, 100.0);
  EXPECT_EQ(look.colors.back().value, 500.0);
}

// Halfway between red and blue, Lab gives purple, and RGB a darker colour.
TEST_F(LookFiles, ParaViewFilesKeepTheColoursOfAnotherColourSpace)
{
  const Look look = this->Read(
    "map.json", R"([ { "ColorSpace": "Lab", "RGBPoints": [0, 1, 0, 0, 100, 0, 0, 1] } ])");
  const glm::dvec3 middle = TransferFunction(look.colors, look.opacities, 1.0).Color(50.0);
  EXPECT_NEAR(middle.r, 0.79, 0.02);
  EXPECT_NEAR(middle.b, 0.53, 0.02);
}

TEST_F(LookFiles, FilesForOtherProgramsReadBackAsWritten)
{
  const Preset preset = BuiltInPreset("ct-bone");
  const Look& look = preset.look;
  for (const std::string name : { "a.json", "a.vp.json", "a.vp", "a.paraview.json", "b.VP" })
  {
    const std::string path = (this->folder / name).string();
    WriteLookFile(preset, path, Ct);
    const Look back = ReadLook(path, "", Ct).look;
    EXPECT_EQ(back.name, name.substr(0, 1)) << name;
    EXPECT_EQ(TextOf(back.opacities), TextOf(look.opacities)) << name;
    ASSERT_EQ(back.colors.size(), look.colors.size()) << name;
    EXPECT_EQ(back.colors[1].rgb, look.colors[1].rgb) << name;
  }
  EXPECT_THROW(WriteLookFile(preset, (this->folder / "a.clut").string(), Ct), std::runtime_error);
}

TEST_F(LookFiles, OnlyOurFilesHoldQualityAndBackground)
{
  Preset preset = BuiltInPreset("ct-bone");
  preset.errorTolerance = 0.125;
  preset.background = { 0.25, 0.5, 0.75 };
  const auto written = [&](const char* name)
  {
    const std::string path = (this->folder / name).string();
    WriteLookFile(preset, path, Ct);
    return ReadLook(path, "", Ct);
  };
  EXPECT_EQ(written("a.json").errorTolerance, preset.errorTolerance);
  EXPECT_EQ(written("a.json").background, preset.background);
  EXPECT_FALSE(written("a.vp.json").errorTolerance);
  EXPECT_FALSE(written("a.vp").background);
  EXPECT_FALSE(written("a.paraview.json").background);
}

TEST_F(LookFiles, MricroGlFilesMayHaveOpacitiesOutOfRange)
{
  const Look look = this->Read("CT_Bones.clut",
    "[FLT]\r\nmin=180\r\nmax=690\r\n[INT]\r\nnumnodes=3\r\n[BYT]\r\nnodeintensity0=0\r\n"
    "nodeintensity1=51\r\nnodeintensity2=255\r\n[RGBA255]\r\nnodergba0=0|0|0|0\r\n"
    "nodergba1=113|102|51|51\r\nnodergba2=255|250|245|16043\r\n");
  EXPECT_EQ(TextOf(look.opacities), "180:0 282:0.2 690:1");
  EXPECT_EQ(look.colors[1].rgb.g, 0.4);
}

TEST_F(LookFiles, MricroGlFilesWithoutValuesAreSpreadOverTheVolume)
{
  const Look look = this->Read("hot.clut",
    "[FLT]\nmin=0\nmax=0\n[INT]\nnumnodes=2\n[BYT]\nnodeintensity0=0\nnodeintensity1=255\n"
    "[RGBA255]\nnodergba0=0|0|0|0\nnodergba1=255|255|255|128\n");
  EXPECT_EQ(look.opacities.front().value, -1000.0);
  EXPECT_EQ(look.opacities.back().value, 3000.0);
}

TEST_F(LookFiles, SlicerScenesHoldSeveralNamedLooks)
{
  const std::string path = this->Write("presets.xml", R"(<MRML version="Slicer4" userTags="">
    <VolumeProperty name="CT-AAA" gradientOpacity="4 0 1 255 1" specularPower="10"
      scalarOpacity="6 -3024 0 143.5 0.5 3071 0.75" specular="0.25" shade="1" ambient="0.125"
      colorTransfer="8 -3024 0 0 0 3071 1 0.5 0.25" diffuse="0.875" interpolation="1"></VolumeProperty>
    <VolumeProperty name="MR-MIP" gradientOpacity="4 0 1 255 1" specularPower="1"
      scalarOpacity="4 0 0 500 1" specular="0" shade="0" ambient="0.25"
      colorTransfer="4 0 1 1 1" diffuse="1"></VolumeProperty></MRML>)");
  const std::vector<Preset> presets = ReadLookFile(path, Ct);
  ASSERT_EQ(presets.size(), 2u);
  EXPECT_EQ(presets[0].look.name, "CT-AAA");
  EXPECT_EQ(TextOf(presets[0].look.opacities), "-3024:0 143.5:0.5 3071:0.75");
  EXPECT_EQ(presets[0].look.colors[1].rgb, glm::dvec3(1.0, 0.5, 0.25));
  EXPECT_EQ(presets[0].look.shading.ambient, 0.125);
  EXPECT_FALSE(ReadLook(path, "MR-MIP", Ct).look.shading.enabled);
}

TEST_F(LookFiles, FileWithSeveralLooksNeedsANameAndListsThem)
{
  const std::string property = "gradientOpacity='2 0 1' specularPower='1' scalarOpacity='2 0 1' "
                               "specular='0' shade='0' ambient='0' colorTransfer='4 0 1 1 1' "
                               "diffuse='1'/>";
  EXPECT_EQ(this->ProblemOf("presets.xml",
              "<MRML><VolumeProperty name='A' " + property + "<VolumeProperty name='B' " +
                property + "</MRML>"),
    "Cannot read presets.xml: expected the name of one of its looks, found the looks A, B.");
}

TEST_F(LookFiles, FijiTablesAreSpreadOverTheVolumeAndKeepItsOpacities)
{
  std::string bytes;
  std::string lines = "Index Red Green Blue\n";
  for (int channel = 0; channel < 3; ++channel)
  {
    for (int i = 0; i < 256; ++i)
    {
      bytes += char(channel == 0 ? i : channel == 1 ? 255 - i : 51);
    }
  }
  for (int i = 0; i < 256; ++i)
  {
    lines += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(255 - i) + " 51\n";
  }
  for (const std::string& file : { bytes, "ICOL" + std::string(28, '\0') + bytes, lines })
  {
    const Look look = this->Read("fire.lut", file);
    ASSERT_EQ(look.colors.size(), 256u);
    EXPECT_EQ(look.colors.front().value, -1000.0);
    EXPECT_EQ(look.colors.back().value, 3000.0);
    EXPECT_EQ(look.colors.back().rgb, glm::dvec3(1.0, 0.0, 0.2));
    EXPECT_EQ(TextOf(look.opacities), TextOf(Ct.opacities));
  }
}

TEST_F(LookFiles, LabelTablesColourSingleValues)
{
  const std::string table = "# Color table file\n0 Background 0 0 0 0\n2 Liver 221 130 101 255\n";
  const std::string descriptions = "# IDX -R- -G- -B- -A-- VIS MSH LABEL\n"
                                   "0 0 0 0 0 0 0 \"Clear Label\"\n"
                                   "2 221 130 101 1 1 1 \"Liver, left\"\n";
  for (const Look& look : { this->Read("a.ctbl", table), this->Read("a.label", descriptions) })
  {
    const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
    EXPECT_EQ(function.Opacity(0.0), 0.0);
    EXPECT_EQ(function.Opacity(1.0), 0.0);
    EXPECT_EQ(function.Opacity(1.75), 1.0);
    EXPECT_EQ(function.Opacity(2.25), 1.0);
    EXPECT_EQ(function.Color(2.25), glm::dvec3(221.0, 130.0, 101.0) / 255.0);
    EXPECT_EQ(function.Opacity(3.0), 0.0);
  }
  EXPECT_EQ(this->ProblemOf("a.ctbl", "1 Liver 221 130\n"),
    "Cannot read a.ctbl: expected lines of index, name, red, green, blue and opacity, found \"1 "
    "Liver 221 130\".");
}

TEST_F(LookFiles, OsirixFilesAreTransparentOutsideTheirCurves)
{
  for (const std::string& bytes : { TwoCurves, InBinary(TwoCurves) })
  {
    const Look look = this->Read("Bone.plist", bytes);
    EXPECT_EQ(TextOf(look.opacities), "-50:0 50:0 199:0 200:0.5 1200:0.75 1201:0");
    EXPECT_EQ(look.colors[3].rgb, glm::dvec3(0.75, 0.5, 1.0));
    EXPECT_FALSE(look.shading.enabled);
  }
}

TEST_F(LookFiles, OverlappingOsirixCurvesUseTheLargerOpacity)
{
  const std::string xml = PlistHead + "<key>16bitClutColors</key><array><array>" +
    PlistColor(0.25) + PlistColor(0.25) + "</array><array>" + PlistColor(0.75) + PlistColor(0.75) +
    "</array></array><key>16bitClutCurves</key><array><array>" + PlistPoint(0, 0) +
    PlistPoint(100, 0.8) + "</array><array>" + PlistPoint(50, 0) + PlistPoint(200, 0.9) +
    "</array></array></dict></plist>";
  const Look look = this->Read("x.plist", xml);
  EXPECT_EQ(TextOf(look.opacities), "0:0 50:0.4 100:0.8 100.1:0.3006 200:0.9 200.15:0");
  EXPECT_EQ(look.colors[1].rgb.r, 0.25);
}

TEST_F(LookFiles, InviwoFilesAreSpreadOverTheVolumeWithinTheirMask)
{
  const Look look = this->Read("tf.itf", R"(<?xml version="1.0" ?>
    <InviwoWorkspace version="3"><maskMin content="0.25" /><maskMax content="1" />
    <type content="0" /><Points>
    <Point><pos content="0" /><rgba x="1" y="0" z="0" w="0" /></Point>
    <Point><pos content="0.5" /><rgba x="0" y="1" z="0" w="0.5" /></Point>
    </Points></InviwoWorkspace>)");
  EXPECT_EQ(TextOf(look.opacities), "0:0 0:0.25 1000:0.5 3000:0.5 3000:0");
  EXPECT_EQ(look.colors.back().rgb, glm::dvec3(0.0, 1.0, 0.0));
}

TEST_F(LookFiles, InviwoFilesOfTheFirstVersionAreReadable)
{
  const Look look = this->Read("tf.itf", R"(<?xml version="1.0" ?><InviwoTreeData version="1.0">
    <dataPoints><point><pos x="0.5" y="0.75" /><rgba x="1" y="0" z="0" w="0.75" /></point>
    </dataPoints></InviwoTreeData>)");
  EXPECT_EQ(TextOf(look.opacities), "1000:0.75");
}

TEST_F(LookFiles, NestedTooDeeplyTheyAreRefused)
{
  constexpr int TooMany = 300000;
  const std::string problem = ": expected at most 30000 elements, found more.";
  EXPECT_EQ(this->ProblemOf("a.itf", Nested("a", TooMany)), "Cannot read a.itf" + problem);
  EXPECT_EQ(this->ProblemOf("a.plist", PlistHead + Nested("array", TooMany)),
    "Cannot read a.plist" + problem);
  std::string trailer(32, '\0');
  trailer[13] = 1;
  EXPECT_EQ(this->ProblemOf("a.plist", "bplist00" + trailer), "Cannot read a.plist" + problem)
    << "65536 objects";
}

TEST_F(LookFiles, NestedLessDeeplyTheyAreRead)
{
  // The deepest ones that are accepted must not exhaust the stack.
  constexpr int Levels = 29000;
  EXPECT_EQ(
    this->ProblemOf("a.itf", Nested("a", Levels)), "Cannot read a.itf: it holds no colours.");
  EXPECT_EQ(
    this->ProblemOf("a.plist",
      PlistHead + "<key>16bitClutCurves</key>" + Nested("array", Levels) + "</dict></plist>"),
    "a.plist: expected the key \"16bitClutColors\", found none");
}

TEST_F(LookFiles, BrokenFilesAreExplained)
{
  EXPECT_EQ(this->ProblemOf("a.json", "[ {"),
    "a.json: not valid JSON: parse error at line 1, column "
    "4: syntax error while parsing object key - "
    "unexpected end of input; expected string literal");
  EXPECT_EQ(this->ProblemOf("a.json", R"([ { "RGBPoints": [0, 1, 0] } ])"),
    "a.json: [0].RGBPoints: expected an array of 4 to 40000, found an array of 3");
  EXPECT_EQ(this->ProblemOf("a.vp.json", R"({ "volumeProperties": [] })"),
    "a.vp.json: volumeProperties: expected an array of 1 to 10000, found an array of 0");
  EXPECT_EQ(this->ProblemOf("a.clut", "[INT]\nnumnodes=1\nnodeintensity0=3\nnodergba0=1|2|x\n"),
    "Cannot read a.clut: expected 4 numbers for nodergba0, found \"1|2|x\".");
  EXPECT_EQ(this->ProblemOf("a.clut", "numnodes=2000000000\n"),
    "Cannot read a.clut: expected 1 to 10000 nodes, found numnodes=2000000000.000000.");
  EXPECT_EQ(this->ProblemOf("a.plist", "bplist00 and then nothing"),
    "Cannot read a.plist: it is not a property list.");
  EXPECT_EQ(
    this->ProblemOf("a.plist", PlistHead + "<key>CLUT</key><string>VR</string></dict></plist>"),
    "Cannot read a.plist: its colours are the table \"VR\", which is not in it.");
  EXPECT_EQ(this->ProblemOf("a.itf", "<a/>"), "Cannot read a.itf: it holds no colours.");
  EXPECT_EQ(this->ProblemOf("a.itf", "no XML at all"), "Cannot read a.itf: it is not valid XML.");
}
