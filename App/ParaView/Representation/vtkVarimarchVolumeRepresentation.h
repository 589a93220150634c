/**
 * @class   vtkVarimarchVolumeRepresentation
 * @brief   ParaView's representation of images as a volume, drawn by
 * vtkVariationFieldVolumeMapper
 *
 * It has the properties of ParaView's "Volume" and those of the mapper that ParaView's does not
 * have: error tolerance, acceleration, shadows and ambient occlusion. Several processes each draw
 * the boxes of cells that they own, with the voxels around them for the light at their faces, and
 * the pictures are composited: still images in floats, others in the 8 bits of ParaView. Before
 * each image they agree on the order of their pictures, and before a still image they search the
 * steps of the whole volume together.
 *
 * Pictures of several processes, and of several images of a multi-block data set, are laid over
 * each other. What this gives no right picture of, projections and shadows, is refused with a
 * message.
 *
 * @sa vtkVariationFieldVolumeMapper
 */

#ifndef vtkVarimarchVolumeRepresentation_h
#define vtkVarimarchVolumeRepresentation_h

#include "VarimarchParaViewRepresentationModule.h" // For export macro
#include "vtkImageVolumeRepresentation.h"
#include "vtkNew.h" // For Part

#include <memory>   // For Image
#include <optional> // For BeginImage
#include <string>   // For ReportedProblem

class vtkPVRenderView;
class vtkRenderer;
class vtkVarimarchPartsMapper;
class vtkVolume;

namespace varimarch
{
class ImageOfProcesses;
struct OwnerOrder;
}

class VARIMARCHPARAVIEWREPRESENTATION_EXPORT vtkVarimarchVolumeRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkVarimarchVolumeRepresentation* New();
  vtkTypeMacro(vtkVarimarchVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Settings of vtkVariationFieldVolumeMapper.
   */
  void SetErrorTolerance(double tolerance);
  void SetAccelerationMode(int mode);
  void SetShadows(bool shadows);
  void SetShadowStrength(double strength);
  void SetAmbientOcclusion(double strength);
  ///@}

  ///@{
  /**
   * Draws still images, and composites those of several processes, in floats instead of ParaView's
   * 8 bits. Default true. The file gets the pixels of each such image (vtkVarimarchFloatPass);
   * default "", for none. The settings of the first visible volume of a view are those of the view.
   */
  void SetFloatCompositing(bool floats);
  void SetFloatImageFile(const char* file);
  ///@}

  ///@{
  /**
   * Settings of ParaView's representation that this one carries out in its own way.
   */
  void SetBlendMode(int blendMode);
  void SetCropping(int cropping);
  void SetVolumetricScatteringBlending(float blending);
  void SetGlobalIlluminationReach(float reach);
  void SetPosition(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

protected:
  vtkVarimarchVolumeRepresentation();
  ~vtkVarimarchVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void UpdateMapperParameters() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  void AgreeWithOthers(vtkObject* renderer, unsigned long event, void* data);
  static vtkVarimarchVolumeRepresentation* FirstVisibleIn(vtkPVRenderView* view);
  void BeginImage(
    vtkRenderer* renderer, const std::optional<varimarch::OwnerOrder>& order, bool inFloats);
  void EndImage(vtkObject* renderer, unsigned long event, void* data);
  void CropToBox();
  bool DimsLight();

  vtkVarimarchPartsMapper* Mapper; // the object in VolumeMapper
  bool Cropping = false;
  bool HasBlocks = false; // true if the input is a data set of several parts
  vtkNew<vtkVolume> Part; // the volume for which steps are found, as ParaView's contains another
  std::unique_ptr<varimarch::ImageOfProcesses> Image;
  bool FloatCompositing = true;
  unsigned long StartObserver = 0;
  unsigned long EndObserver = 0;
  std::string ReportedProblem;

  vtkVarimarchVolumeRepresentation(const vtkVarimarchVolumeRepresentation&) = delete;
  void operator=(const vtkVarimarchVolumeRepresentation&) = delete;
};

#endif
