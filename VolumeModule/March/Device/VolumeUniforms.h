#ifndef Varimarch_March_Device_VolumeUniforms_h
#define Varimarch_March_Device_VolumeUniforms_h

#include "March/Device/RayMarchProgram.h"
#include "Resources/VolumeResources.h"

namespace varimarch
{

/// The volume or a block of it, as it is drawn.
struct DrawnBlock
{
  const VolumeBlock* block; ///< none where rays are not marched
  VoxelRegion voxels;
  Box boxGrid;                ///< what its rays are marched through
  Box coverGrid;              ///< covers their pixels
  glm::dvec3 sharedUpperGrid; ///< upper faces at which another block begins; elsewhere far away
};

/// Tells a program of one volume, when all its resources of a frame are there: the uniforms of each
/// slot.
class VolumeUniforms
{
public:
  VolumeUniforms(RayMarchProgram& program, const VolumeResources& resources, const Frame& frame)
    : program(program)
    , resources(resources)
    , frame(frame)
  {
  }

  void SetPlace(const DrawnBlock& drawn);
  void SetMarch(const DrawnBlock& drawn);
  void SetCuts();
  void SetBlend();
  void SetClassify();
  /// Of one of several volumes that overlap.
  void SetOwnGrid(const glm::dmat4& gridFromRays);

private:
  void SetProjection();
  void SetExact(const DrawnBlock& drawn);
  void SetSpacing();
  void SetSteps(const VolumeBlock& block);
  void SetPreIntegrated();
  void SetTwoValues();
  void SetGaps(const DrawnBlock& drawn);
  void SetMask();

  // Of materials.
  void SetMaterial(const DrawnBlock& drawn);
  void SetComponentTables();
  void SetComponents();
  void SetComponentProjection();
  void SetLights();
  void SetGradientOpacity();

  RayMarchProgram& program;
  const VolumeResources& resources;
  const Frame& frame;
};

}

#endif
