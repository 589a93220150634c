#ifndef Varimarch_Scene_ColorTables_h
#define Varimarch_Scene_ColorTables_h

#include "Scene/LookFormats/LookContext.h"

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

}

#endif
