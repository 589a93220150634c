/**
 * @class   vtkVariationFieldGPUVolumeRayCastMapper
 * @brief   The variation field mapper where a program expects VTK's GPU mapper
 *
 * Programs that leave the choice of a mapper to VTK, by vtkGPUVolumeRayCastMapper::New,
 * vtkSmartVolumeMapper or vtkMultiBlockVolumeMapper, get this class from the plugin, without a
 * change of code; Documentation/Plugin.md says how. It takes every setting of those classes, and
 * draws with a vtkVariationFieldVolumeMapper that it owns.
 *
 * Nothing is lost by that: what the variation field mapper cannot draw yet is drawn by VTK's own
 * mapper, whole, which is why this class inherits it. GetReasonForVtkMapper names the feature. With
 * the environment variable VARIMARCH_VERBOSE set, the same is printed once per change.
 *
 * Quality: while the choice of the sample distance is left to the mapper, by
 * AutoAdjustSampleDistances (VTK's default) or LockSampleDistanceToInputSpacing (always on in
 * vtkSmartVolumeMapper), pictures keep the ErrorTolerance of GetVariationFieldMapper, and need no
 * jitter. Otherwise SampleDistance is used as it is. MaxMemoryInBytes and partitions are left to
 * the mapper.
 *
 * @sa vtkVariationFieldVolumeMapper vtkOpenGLGPUVolumeRayCastMapper
 */

#ifndef vtkVariationFieldGPUVolumeRayCastMapper_h
#define vtkVariationFieldGPUVolumeRayCastMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkNew.h"                // For the mapper that draws
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <string> // For the reason

class vtkVariationFieldVolumeMapper;

class VARIMARCHVOLUME_EXPORT vtkVariationFieldGPUVolumeRayCastMapper
  : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkVariationFieldGPUVolumeRayCastMapper* New();
  vtkTypeMacro(vtkVariationFieldGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mapper that draws, for the settings that VTK's has not: error tolerance, acceleration and
   * others. Those that both have are overwritten by this class with each picture.
   */
  vtkVariationFieldVolumeMapper* GetVariationFieldMapper();

  /**
   * Why VTK's own mapper has drawn the last picture: sentences that name what the variation field
   * mapper cannot draw yet. Empty when that one has drawn it.
   */
  const char* GetReasonForVtkMapper();

  /**
   * INTERNAL: called by the volume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  ///@{
  /**
   * With RenderToImage: what was drawn last.
   */
  void GetColorImage(vtkImageData* image) override;
  void GetDepthImage(vtkImageData* image) override;
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkVariationFieldGPUVolumeRayCastMapper();
  ~vtkVariationFieldGPUVolumeRayCastMapper() override;

private:
  void ForwardSettings();
  std::string UnsupportedSetting();
  void ChooseMapper(vtkRenderer* renderer, vtkVolume* volume);
  void Draw(vtkRenderer* renderer, vtkVolume* volume);

  vtkNew<vtkVariationFieldVolumeMapper> VariationFieldMapper;
  std::string ReasonForVtkMapper;
  std::string ToldUser;

  vtkVariationFieldGPUVolumeRayCastMapper(const vtkVariationFieldGPUVolumeRayCastMapper&) = delete;
  void operator=(const vtkVariationFieldGPUVolumeRayCastMapper&) = delete;
};

#endif
