#ifndef Varimarch_Scene_LookFormats_h
#define Varimarch_Scene_LookFormats_h

#include "Scene/Looks/LookFormats/LookContext.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

// Tables of colours. The functions throw std::runtime_error with one sentence; their `file` names
// the look, and the text in errors.

/// Fiji's and ImageJ's *.lut: 256 reds, greens and blues in bytes, with or without the header of
/// NIH Image, or lines of three numbers from 0 to 255, with or without an index in front. The
/// colours are spread over the range of the volume's values, and the opacities are those of the
/// context.
Look LookFromLut(const std::string& bytes, const std::string& file, const LookContext& context);

/// 3D Slicer's *.ctbl: lines of an index, a name without blanks, and red, green, blue and opacity
/// from 0 to 255. Each colour and opacity belongs to one value of a label map.
Look LookFromCtbl(const std::string& text, const std::string& file, const LookContext& context);

/// ITK-SNAP's *.label: lines of an index, red, green and blue from 0 to 255, opacity from 0 to 1,
/// two flags for visibility, and a name in quotes. Each colour and opacity belongs to one value.
Look LookFromLabelDescriptions(
  const std::string& text, const std::string& file, const LookContext& context);

/// Segments of either kind of table, which names in quotes tell apart. In FreeSurfer's tables,
/// which are those of 3D Slicer otherwise, all opacities are 0 and mean nothing.
std::vector<Segment> SegmentsFromTable(const std::string& text, const std::string& file);

/// Reads Inviwo's transfer functions, *.itf: XML of any version. Nodes lie between 0 and 1 over the
/// range of the volume's values, or at values; only those between the two ends of the mask are
/// visible.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromItf(const std::string& text, const std::string& file, const LookContext& context);

/// Reads MRIcroGL's colour tables, *.clut: lines of KEY=VALUE with nodes from 0 to 255 between two
/// values. A table without the two values is spread over the range of the volume's.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromClut(const std::string& text, const std::string& file, const LookContext& context);

/// Reads 3D presets and 16-bit colour tables of OsiriX, Horos and InVesalius, *.plist, XML or
/// binary: opacity curves with a colour at each point, transparent outside them. Where two curves
/// overlap, the one with the larger opacity is used. Tables of 256 colours without opacities are
/// spread over the context's opacities.
/// @param file  name of the look, and of the bytes in errors
/// @throws std::runtime_error with one sentence
Look LookFromPlist(const std::string& bytes, const std::string& file, const LookContext& context);

/// ParaView's colour maps, *.json: colours with or without opacities. Only the first map of a file
/// is read.

/// True if a JSON value looks like a ParaView colour map.
bool IsParaViewColorMap(const nlohmann::json& json);

/// Reads a colour map. A map on [0, 1], as ParaView ships them, is spread over the range of the
/// volume's values or, if it has only colours, over that of the context's opacities.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromParaViewJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);

/// @param look  in units of the data; light, blend mode and gradient opacity are not written
std::string ParaViewJson(const Look& look);

/// 3D Slicer's volume property files. The reading functions throw std::runtime_error with one
/// sentence; their `file` names the look, and the text in errors. The writing functions take looks
/// in units of the data.

/// The settings of a volume property as texts of numbers. Curves begin with the count of their
/// numbers.
struct SlicerNumbers
{
  std::string shade;
  std::string diffuse;
  std::string ambient;
  std::string specular;
  std::string specularPower;
  std::string scalarOpacity;   ///< value and opacity for each node
  std::string gradientOpacity; ///< gradient and opacity for each node
  std::string colors;          ///< value, red, green and blue for each node
};
Look LookFromSlicerNumbers(
  const SlicerNumbers& texts, const std::string& file, const LookContext& context);

/// *.vp: nine lines of numbers, without midpoints, sharpness, blend mode and unit distance.
Look LookFromSlicerText(
  const std::string& text, const std::string& file, const LookContext& context);
std::string SlicerText(const Look& look, const LookContext& context);

/// *.vp.json. Only the first component of the first property is read. There is no blend mode.
Look LookFromSlicerJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);
std::string SlicerJson(const Look& look, const LookContext& context);

/// Reads the volume properties in a MRML scene of 3D Slicer, such as its presets.xml. Their names
/// become those of the looks.
/// @param file  text that names the file in errors
/// @throws std::runtime_error with one sentence
std::vector<Look> LooksFromSlicerScene(
  const std::string& text, const std::string& file, const LookContext& context);

}

#endif
