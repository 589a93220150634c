#ifndef Varimarch_Promise_JudgeScene_h
#define Varimarch_Promise_JudgeScene_h

#include "JudgeVolume.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <limits>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// A light that is on.
struct JudgeLamp
{
  bool isAtEye; ///< a distant head light: it casts no shadow
  bool isNear;  ///< it has a position, else only a direction
  glm::dvec3 position;
  glm::dvec3 shinesAlong; ///< unit vector
  glm::dvec3 diffuse;
  glm::dvec3 specular;
  glm::dvec3 attenuation; ///< constant, per mm, per mm^2
  double coneDegrees;
  double exponent;
  double softnessDegrees;
};

using JudgeTriangle = std::array<glm::dvec3, 3>;

/// Everything that a picture shows, in plain numbers.
struct JudgeScene
{
  std::vector<JudgeVolume> volumes; ///< at least one
  int blendMode;                    ///< as in vtkVolumeMapper
  double errorTolerance;

  std::vector<JudgeLamp> lamps;
  glm::dvec3 ambientLight;
  bool isTwoSided;
  bool hasShadows;
  double shadowStrength;
  double scatteredPart; ///< [0, 1]
  double anisotropy;
  double scatterReachMm; ///< reach of light that is scattered, without shadows
  double occlusion;
  double occlusionReachMm;

  std::vector<JudgeTriangle> seen;    ///< opaque geometry
  std::vector<JudgeTriangle> casting; ///< the part of it that casts shadows

  std::vector<double> isovalues; ///< sorted
  double averagedRange[2];
  double grayRange[2];

  glm::dmat4 worldFromClip;
  bool isParallel;
  int width; ///< [pixels]
  int height;

  bool IsLit() const { return this->hasShadows || this->occlusion > 0.0 || this->Scatters(); }
  bool Scatters() const { return this->scatteredPart > 0.0; }
};

/// The objects of VTK that make a picture.
struct JudgedObjects
{
  vtkRenderer* renderer;
  vtkVariationFieldVolumeMapper* mapper; ///< the settings of light, cuts and blending
  std::vector<vtkImageData*> images;
  std::vector<vtkVolume*> volumes; ///< one for each image
  std::vector<vtkActor*> actors;   ///< opaque geometry
};

/// Reads the scene of the last Render by VTK's own interface. Images have one component of point
/// data.
JudgeScene ReadJudgeScene(const JudgedObjects& objects);

}

#endif
