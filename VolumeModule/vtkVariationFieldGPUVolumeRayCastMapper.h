/**
 * @class   vtkVariationFieldGPUVolumeRayCastMapper
 * @brief   A drop-in replacement for VTK's GPU mapper that draws with the variation field mapper
 *
 * Programs that leave the choice of a mapper to VTK, by vtkGPUVolumeRayCastMapper::New,
 * vtkSmartVolumeMapper or vtkMultiBlockVolumeMapper, get this class from the plugin without a
 * change of code; see Documentation/Plugin.md. It accepts all settings of those classes and draws
 * with a vtkVariationFieldVolumeMapper that it owns.
 *
 * If that mapper does not support a feature, VTK's own mapper draws the whole volume instead; this
 * is why this class inherits it. GetReasonForVtkMapper() then names the feature. If the environment
 * variable VARIMARCH_VERBOSE is set, the reason is also printed to standard error each time it
 * changes.
 *
 * Quality: if AutoAdjustSampleDistances (VTK's default) or LockSampleDistanceToInputSpacing (always
 * on in vtkSmartVolumeMapper) is on, images keep the ErrorTolerance of GetVariationFieldMapper()
 * and need no jitter. Otherwise SampleDistance is used unchanged. MaxMemoryInBytes and partitions
 * have no effect: the mapper chooses its blocks itself.
 *
 * @sa vtkVariationFieldVolumeMapper vtkOpenGLGPUVolumeRayCastMapper
 */

#ifndef vtkVariationFieldGPUVolumeRayCastMapper_h
#define vtkVariationFieldGPUVolumeRayCastMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkNew.h"                // For VariationFieldMapper
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <string> // For ReasonForVtkMapper

class vtkVariationFieldVolumeMapper;

class VARIMARCHVOLUME_EXPORT vtkVariationFieldGPUVolumeRayCastMapper
  : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkVariationFieldGPUVolumeRayCastMapper* New();
  vtkTypeMacro(vtkVariationFieldGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The error tolerance of mappers that are made from now on, 0 to 1, for programs that never see
   * their mapper. The default is the environment variable VARIMARCH_ERROR_TOLERANCE, or 1/64
   * without it. A value that is not a number from 0 to 1 is reported and not used.
   */
  static void SetDefaultErrorTolerance(double tolerance);
  static double GetDefaultErrorTolerance();
  ///@}

  /**
   * The mapper that draws. Use it for settings that VTK's mapper does not have, such as error
   * tolerance and acceleration, and scattering before VTK 9.2. Settings that both have are
   * overwritten by this class for each frame.
   */
  vtkVariationFieldVolumeMapper* GetVariationFieldMapper();

  /**
   * The reason why VTK's own mapper drew the last frame: sentences that name the unsupported
   * features. Empty if the variation field mapper drew it.
   */
  const char* GetReasonForVtkMapper();

  /**
   * INTERNAL: called by the volume.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * INTERNAL: chooses the mapper for the next frame. Returns true for the variation field mapper,
   * false for VTK's own.
   */
  bool ChooseMapper(vtkRenderer* renderer, vtkVolume* volume);

  ///@{
  /**
   * The colours and depths of the last frame drawn with RenderToImage.
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
  void Draw(vtkRenderer* renderer, vtkVolume* volume);

  vtkNew<vtkVariationFieldVolumeMapper> VariationFieldMapper;
  std::string ReasonForVtkMapper;
  std::string ReportedChoice;

  vtkVariationFieldGPUVolumeRayCastMapper(const vtkVariationFieldGPUVolumeRayCastMapper&) = delete;
  void operator=(const vtkVariationFieldGPUVolumeRayCastMapper&) = delete;
};

#endif
