#ifndef vtkComparisonMapper_h
#define vtkComparisonMapper_h

#include "VoxelStorage.h"

#include <vtkSmartPointer.h>
#include <vtkVolumeMapper.h>

#include <memory>

/// Draws composites of one component as published methods do that this project compares itself
/// with: slices, a march in several passes, half-angle slices, a volume of light, voxels in fewer
/// bits. It is part of the benchmarks only; the product does not know it. It draws no cuts, masks,
/// labels, gradient opacity or opaque geometry. Methods without shadows light samples by a white
/// light at the eye, those with shadows by a white light far away.
class vtkComparisonMapper : public vtkVolumeMapper
{
public:
  static vtkComparisonMapper* New();
  vtkTypeMacro(vtkComparisonMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    ObjectSlices,   ///< slices across an axis of the volume, from a 3D texture
    ObjectSlices2D, ///< the same, from three stacks of 2D textures
    ViewSlices,     ///< slices parallel to the image
    Shells,         ///< spherical shells around the eye
    Passes,         ///< ray marching in several passes
    HalfAngle,      ///< slices halfway between view and light, with shadows
    LightVolume,    ///< slices parallel to the image, with shadows from a volume of light
    SecondMarch,    ///< as Passes, with shadows by a second march from each sample to the light
    VtkShadows      ///< the same by the rays of VTK 9.2 and later
  };

  ///@{
  /// Default: ViewSlices.
  vtkSetClampMacro(Method, int, ObjectSlices, VtkShadows);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /// Storage of the voxels, for all methods but ObjectSlices2D. Default: Bits16.
  vtkSetEnumMacro(Storage, varimarch::VoxelStorage);
  vtkGetEnumMacro(Storage, varimarch::VoxelStorage);
  ///@}

  ///@{
  /// Passes: the table has the opacities of whole steps, so that samples need no exponential.
  /// Default: off.
  vtkSetMacro(CorrectedTable, bool);
  vtkGetMacro(CorrectedTable, bool);
  ///@}

  ///@{
  /// Distance between slices or samples [mm], > 0. ObjectSlices2D rounds it to whole voxels, at
  /// least one. Default: 1.
  vtkSetClampMacro(SampleDistance, double, 1e-30, 1e30);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /// Slices other than half-angle, and shells: blend them over each other, from the back to the
  /// front, instead of under each other. Default: on.
  vtkSetMacro(FromBehind, bool);
  vtkGetMacro(FromBehind, bool);
  ///@}

  ///@{
  /// Marches in passes: steps per pass, > 0, and the transmittance below which a ray ends.
  /// Defaults: 32 and 1/1024.
  vtkSetClampMacro(StepsPerPass, int, 1, 65536);
  vtkGetMacro(StepsPerPass, int);
  vtkSetClampMacro(EarlyTerminationTransmittance, double, 0.0, 0.999999);
  vtkGetMacro(EarlyTerminationTransmittance, double);
  ///@}

  ///@{
  /// Methods with shadows: the direction towards the light in the camera's right, up and
  /// backward directions, of any length. Default: from above at 45 degrees.
  vtkSetVector3Macro(LightDirection, double);
  vtkGetVector3Macro(LightDirection, double);
  ///@}

  ///@{
  /// HalfAngle: half the angle of the cone in which light is scattered [degrees]. Default: 20.
  /// Without an angle there are shadows only.
  vtkSetClampMacro(SpreadDegrees, double, 0.0, 80.0);
  vtkGetMacro(SpreadDegrees, double);
  ///@}

  ///@{
  /// LightVolume: points of the grid of light along the longest axis of the volume, >= 2. Default:
  /// 64.
  vtkSetClampMacro(LightPoints, int, 2, 1024);
  vtkGetMacro(LightPoints, int);
  ///@}

  /// Textures of the volume, its look and its light in the last frame [bytes].
  double GetGraphicsMemoryBytes();
  /// The part of it that is for light alone.
  double GetLightMemoryBytes();

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkComparisonMapper();
  ~vtkComparisonMapper() override;

private:
  struct Internals;

  int Method = ViewSlices;
  varimarch::VoxelStorage Storage = varimarch::VoxelStorage::Bits16;
  bool CorrectedTable = false;
  double SampleDistance = 1.0;
  bool FromBehind = true;
  int StepsPerPass = 32;
  double EarlyTerminationTransmittance = 1.0 / 1024.0;
  double LightDirection[3] = { 0.0, 1.0, 1.0 };
  double SpreadDegrees = 20.0;
  int LightPoints = 64;
  std::unique_ptr<Internals> Private;

  vtkComparisonMapper(const vtkComparisonMapper&) = delete;
  void operator=(const vtkComparisonMapper&) = delete;
};

#endif
