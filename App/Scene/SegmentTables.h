#ifndef Varimarch_Scene_SegmentTables_h
#define Varimarch_Scene_SegmentTables_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Reads names, colours and visibility of labels from a table of 3D Slicer (.ctbl), FreeSurfer
/// (FreeSurferColorLUT.txt) or ITK-SNAP (.label, .txt), which its lines tell apart.
/// @throws std::runtime_error with one sentence that names the file
std::vector<Segment> ReadSegmentTable(const std::string& path);

/// Gives the segments whose values are in a table its name, colour, visibility and opacity.
void TakeTable(const std::vector<Segment>& table, std::vector<Segment>& segments);

}

#endif
