#ifndef Varimarch_Scene_SegmentDrawing_h
#define Varimarch_Scene_SegmentDrawing_h

#include "Scene/LabelMap.h"

class vtkVolumeProperty;

namespace varimarch
{

// Drawing of segments by the label map masks of VTK's mappers. A visible segment has one colour and
// one opacity, whatever the values of the scan. The rest is drawn as the look says.

/// Gives each segment of a label map its functions.
/// @param property  has the functions of a look
/// @param segments  as many as the labels have, in their order
void ApplySegments(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property);

/// Gives a volume of its own, whose values are the numbers of the segments and whose voxels are
/// boxes, the colours and opacities of the visible ones, where a mapper has no masks.
void ApplySegmentsByNumber(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property);

/// The mask of a mapper for labels, without what scissors remove.
/// @param kept  as MaskOf in Scissors.h returns it; may be null
vtkSmartPointer<vtkImageData> LabelMask(const LabelMap& labels, vtkImageData* kept);

}

#endif
