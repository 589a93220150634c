#ifndef Varimarch_Scene_Segments_h
#define Varimarch_Scene_Segments_h

#include "Scene/Model/Scene.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Masks of VTK's mappers have 8 bits, and one value stands for what scissors remove. The smallest
/// of more labels share the last segment.
constexpr int MostSegments = 254;

/// More different values are no labels but those of a scan.
constexpr int MostLabels = 2000;

constexpr int SmallestLabel = std::numeric_limits<int>::min();
constexpr int LargestLabel = std::numeric_limits<int>::max();

/// Colour of a label for which a file gives none. Neighbouring labels differ much, and those from 1
/// to 7 for every kind of colour vision.
glm::dvec3 ColorOfLabel(int value);

/// "Label 3", the name of a label for which a file gives none.
std::string NameOfLabel(int value);

/// The known segments of an image of labels, and one more for every other value but 0. Of more than
/// MostSegments the largest stay, and the last stands for all others.
/// @param warnings  receives a sentence if labels share a segment
/// @throws std::invalid_argument whose words say what was expected and found, if the values are not
///         labels or more than MostLabels
std::vector<Segment> SegmentsOf(
  vtkImageData* labels, const std::vector<Segment>& known, std::vector<std::string>& warnings);

/// An image of the same grid whose voxels number the segments: i + 1 in segment i, 0 in none.
/// Labels of no segment are in the last one.
/// @param segments  as SegmentsOf returns them
vtkSmartPointer<vtkImageData> SegmentNumbers(
  vtkImageData* labels, const std::vector<Segment>& segments);

/// Size of a segment on a grid.
struct SegmentSize
{
  std::int64_t voxels = 0;
  double volumeMl = 0.0;
  double thicknessMm = 0.0; ///< mean length of the lines through it; 0 without voxels
};

/// Sizes of all segments.
/// @param numbers  as SegmentNumbers returns them
/// @param count    number of segments
std::vector<SegmentSize> SizesOf(vtkImageData* numbers, std::size_t count);

/// Reads names, colours and visibility of labels from a table of 3D Slicer (.ctbl), FreeSurfer
/// (FreeSurferColorLUT.txt) or ITK-SNAP (.label, .txt), which its lines tell apart.
/// @throws std::runtime_error with one sentence that names the file
std::vector<Segment> ReadSegmentTable(const std::string& path);

/// Gives the segments whose values are in a table its name, colour, visibility and opacity.
void TakeTable(const std::vector<Segment>& table, std::vector<Segment>& segments);

}

#endif
