/**
 * @class   vtkVarimarchPartsMapper
 * @brief   draws several images and rectilinear grids that do not overlap as one volume
 *
 * Each part has a vtkVariationFieldVolumeMapper of its own with the settings of this one, and they
 * draw back to front, over each other. The input of this mapper is not drawn; ParaView's volume
 * only asks whether it has the array. Projections, whose pictures cannot be laid over each other,
 * and shadows of one part on another are not possible.
 *
 * @sa vtkVarimarchVolumeRepresentation
 */

#ifndef vtkVarimarchPartsMapper_h
#define vtkVarimarchPartsMapper_h

#include "OwnedPart.h"                             // For OwnedPart
#include "Tolerance/SharedSearch.h"                // For SharedSearch
#include "VarimarchParaViewRepresentationModule.h" // For export macro
#include "vtkVariationFieldVolumeMapper.h"

#include <memory>   // For Drawers
#include <optional> // For CommonSteps
#include <string>   // For SelectArray
#include <vector>   // For Parts

class VARIMARCHPARAVIEWREPRESENTATION_NO_EXPORT vtkVarimarchPartsMapper
  : public vtkVariationFieldVolumeMapper
{
public:
  static vtkVarimarchPartsMapper* New();
  vtkTypeMacro(vtkVarimarchPartsMapper, vtkVariationFieldVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The parts that are drawn, each without its neighbours' voxels.
   */
  void SetParts(std::vector<varimarch::OwnedPart> parts);
  const std::vector<varimarch::OwnedPart>& GetParts() const { return this->Parts; }

  /**
   * Bounds of all parts, in the coordinates of the data.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  using Superclass::GetBounds;

  /**
   * Finds the steps with which all parts on all processes are drawn in the next still image.
   * All of these processes must call this.
   * @param volume  nothing of it is drawn if it is not visible
   * @return the steps; none if each part finds its own
   */
  std::optional<varimarch::CommonSteps> FindSteps(
    vtkRenderer* renderer, vtkVolume* volume, const varimarch::SearchingProcesses& processes);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkVarimarchPartsMapper();
  ~vtkVarimarchPartsMapper() override;

  void DrawFrame(vtkRenderer* renderer, vtkVolume* volume) override;

private:
  struct Drawer;

  void ForwardSettings(vtkVolume* volume);
  void CropPart(const varimarch::OwnedPart& part, vtkVolumeMapper* mapper);
  void SelectArray(const std::string& added, vtkVolumeMapper* mapper);
  std::vector<int> PartsFrontToBack(vtkRenderer* renderer, vtkVolume* volume);

  std::vector<varimarch::OwnedPart> Parts;
  std::vector<std::unique_ptr<Drawer>> Drawers; // one for each part
  varimarch::SharedSearch Search;

  vtkVarimarchPartsMapper(const vtkVarimarchPartsMapper&) = delete;
  void operator=(const vtkVarimarchPartsMapper&) = delete;
};

#endif
