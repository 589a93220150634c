#ifndef Varimarch_Benchmarks_VtkSettings_h
#define Varimarch_Benchmarks_VtkSettings_h

class vtkFixedPointVolumeRayCastMapper;
class vtkGPUVolumeRayCastMapper;
class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Give VTK's own mappers the input and the settings of ours that they have too.
void CopySettings(vtkVariationFieldVolumeMapper* from, vtkGPUVolumeRayCastMapper* to);
void CopySettings(vtkVariationFieldVolumeMapper* from, vtkFixedPointVolumeRayCastMapper* to);

}

#endif
