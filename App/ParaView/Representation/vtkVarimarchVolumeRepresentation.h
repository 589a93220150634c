/**
 * @class   vtkVarimarchVolumeRepresentation
 * @brief   ParaView's representation of an image as a volume, drawn by
 * vtkVariationFieldVolumeMapper
 *
 * It has the properties of ParaView's "Volume" and those of the mapper that ParaView's does not
 * have: error tolerance, acceleration and shadows. Several processes each draw the box of cells
 * that they own, with the voxels around it for the light at its faces, and ParaView composites the
 * pictures. Before a still image they agree on steps: the shortest that any of them needs.
 *
 * ParaView lays the pictures of several processes over each other. Blend modes for which this gives
 * no right picture, all projections, are refused with a message if there is more than one process.
 *
 * @sa vtkVariationFieldVolumeMapper
 */

#ifndef vtkVarimarchVolumeRepresentation_h
#define vtkVarimarchVolumeRepresentation_h

#include "VarimarchParaViewRepresentationModule.h" // For export macro
#include "vtkImageVolumeRepresentation.h"
#include "vtkNew.h" // For Part

#include <cstddef> // For Grids
#include <string>  // For ReportedProblem

class vtkDataArray;
class vtkDataSet;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

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
  ///@}

  ///@{
  /**
   * Settings of ParaView's representation that this one carries out in its own way.
   */
  void SetBlendMode(int blendMode);
  void SetCropping(int cropping);
  void SetVolumetricScatteringBlending(float blending);
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
  void AgreeOnSteps(vtkObject* renderer, unsigned long event, void* data);
  void CropToOwnPart();
  void ChooseScalars();
  std::string Problem();
  void BoundsInWorld(double bounds[6]);

  vtkVariationFieldVolumeMapper* Mapper; // the object in VolumeMapper
  bool Cropping = false;
  bool HasNeighbours = false; // true if the cache has voxels of other processes around DataBounds
  bool HasParts = false;      // true if the input is a data set of several parts
  std::size_t Grids = 0;      // the number of those parts of this process that can be drawn
  vtkNew<vtkVolume> Part; // the volume for which steps are found, as ParaView's contains another
  unsigned long Observer = 0;
  std::string ReportedProblem;
  vtkSmartPointer<vtkDataArray> Scalars; // the scalars that were made from a vector
  vtkMTimeType ScalarsTime = 0;
  std::string ScalarsSource;

  vtkVarimarchVolumeRepresentation(const vtkVarimarchVolumeRepresentation&) = delete;
  void operator=(const vtkVarimarchVolumeRepresentation&) = delete;
};

#endif
