/**
 * @class   vtkMaterialVolumeMapper
 * @brief   How a volume mapper shows the matter of a volume
 *
 * The settings of vtkVariationFieldVolumeMapper for what a vtkVolumeProperty does not describe:
 * light that the volume dims, masks and label maps, and values that are missing.
 */

#ifndef vtkMaterialVolumeMapper_h
#define vtkMaterialVolumeMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkSampledVolumeMapper.h"
#include "vtkSmartPointer.h" // For MaskInput

class vtkImageData;
class vtkInformationDoubleKey;
class vtkInformationIntegerKey;

class VARIMARCHVOLUME_EXPORT vtkMaterialVolumeMapper : public vtkSampledVolumeMapper
{
public:
  vtkTypeMacro(vtkMaterialVolumeMapper, vtkSampledVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Colour and opacity, each in [0, 1], of cells that touch a non-finite voxel (NaN or infinity). A
   * composite draws them as a homogeneous, unshaded material with this opacity over one
   * vtkVolumeProperty::ScalarOpacityUnitDistance; all other blend modes leave them out. The names
   * are those of vtkLookupTable. The NaN colours of the property's functions are not used, because
   * they are opaque by default. Defaults: opacity 0, colour (0.5, 0, 0).
   */
  vtkSetVector3Macro(NanColor, double);
  vtkGetVector3Macro(NanColor, double);
  vtkSetClampMacro(NanOpacity, double, 0.0, 1.0);
  vtkGetMacro(NanOpacity, double);
  ///@}

  ///@{
  /**
   * A gradient magnitude below which diffuse and specular light are reduced in proportion.
   * A homogeneous material, whose gradient is noise, then keeps only its ambient light, and
   * surfaces stand out. Units: scalar value per mean voxel spacing, as for gradient opacity.
   * Applies to volumes of one component. Default: 0, no reduction. Source: Volt (2009).
   */
  vtkSetClampMacro(DampingGradient, double, 0.0, 1e30);
  vtkGetMacro(DampingGradient, double);
  ///@}

  ///@{
  /**
   * Let the volume cast shadows on itself, and overlapping volumes on each other: the diffuse and
   * specular light of each of the renderer's first eight lights that are not at the eye is
   * multiplied by what the volumes between the light and the sample let through. Ambient light and
   * lights at the eye cast none. Requires a composite with shading; volumes without shading cast
   * shadows on others. The error tolerance holds for the image with its shadows, which takes about
   * three times as long as without and, where shaders draw it, many times as long. The light that
   * reaches the visible parts is kept while the volume, its look and a light stay, in up to an
   * eighth of a byte for each voxel and light. Packets of rays on the processor draw
   * those of a volume that does not fit into the graphics memory (see ProcessorMarching). Default:
   * off.
   *
   * Opaque geometry casts shadows on the volume too: the faces of the renderer's visible actors,
   * also in assemblies and outside the view, as far as their mappers' clipping planes leave them.
   * Translucent actors, lines, points, wireframes, glyphs, a vtkSkybox and representations of
   * widgets cast none (actors of a vtk3DWidget do), nor does a prop with the key CASTS_SHADOWS set
   * to 0, nor more than two million triangles, nor a vtkDataSetMapper of other data than polygons
   * before its first drawing, nor does geometry take away scattered light without Shadows.
   *
   * The same faces receive the shadows of the renderer's volumes: the colours that VTK has drawn
   * are multiplied by the part of their light that is left, also those of lines or glyphs that lie
   * on a face. Several volumes with mappers of their own leave their common shadow. The steps of
   * that light are found for it, so that it keeps the error tolerance. Images during interaction
   * have as many places of light as rays of the volume (see MinimumImageSampleDistance). Behind
   * translucent geometry, peeled or not, what that adds keeps its light; it is drawn twice then.
   * With RenderToImage the faces in the window are dimmed. A volume that has been drawn once with
   * shadows and geometry keeps casting them when it leaves the view: it adds a vtkCuller to the
   * renderer, so that vtkFrustumCoverageCuller does not leave it out. Shader code of the user, and
   * shaders for overlapping volumes or blocks, leave all that out. So does a renderer that shows a
   * volume of another mapper without depth peeling for volumes, or translucent geometry by a
   * vtkRenderPass of the caller or beside UseShadows. VTK lets geometry cast shadows on geometry
   * (vtkShadowMapPass).
   */
  vtkSetClampMacro(Shadows, vtkTypeBool, 0, 1);
  vtkGetMacro(Shadows, vtkTypeBool);
  vtkBooleanMacro(Shadows, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Strength of Shadows, [0, 1]: the part of what matter takes from a light that surfaces lack. At
   * 0 there are no shadows. Scattered light is dimmed by all of it. Default: 1.
   */
  vtkSetClampMacro(ShadowStrength, double, 0.0, 1.0);
  vtkGetMacro(ShadowStrength, double);
  ///@}

  /**
   * Softness of a light, a key of vtkLight::GetInformation() [degrees, 0 to 90]: half the angle of
   * the cone that it comes from. Its shadows are the mean over twelve directions in that cone
   * (Documentation/Mathematics.md) and take several times as long; highlights and scattering are
   * those of its middle. Without the key a light is a point.
   */
  static vtkInformationDoubleKey* LIGHT_SOFTNESS();

  /**
   * Whether a prop of opaque geometry casts shadows on volumes, a key of
   * vtkProp::GetPropertyKeys(): 0 if it casts none and receives none. Without the key it does.
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();

  ///@{
  /**
   * Part of the diffuse and specular light that matter scatters, once, instead of reflecting it,
   * [0, 2]; from 1 on all is scattered, as in VTK in the limit of short steps. Scattered light is
   * the colour times the diffuse coefficient times the phase function of Henyey and Greenstein,
   * whose mean over all directions is 1. Requires a composite with shading. Default: 0.
   */
  vtkSetClampMacro(VolumetricScatteringBlending, double, 0.0, 2.0);
  vtkGetMacro(VolumetricScatteringBlending, double);
  ///@}

  ///@{
  /**
   * Distance over which the volume dims light before it is scattered, [0, 1]. As in VTK it is
   * 1 - (1 - reach)^0.33 diagonals of the volume, and unlimited for 1. With Shadows it is unlimited
   * for all light. Lights at the eye are not dimmed. Default: 0.
   */
  vtkSetClampMacro(GlobalIlluminationReach, double, 0.0, 1.0);
  vtkGetMacro(GlobalIlluminationReach, double);
  ///@}

  ///@{
  /**
   * Mean cosine of the angle by which scattering turns light, limited to [-0.99, 0.99]: light goes
   * straight on near 1, back near -1, and to all sides alike at 0. Default: 0, which takes that of
   * the volume's property, since VTK 9.2.
   */
  vtkSetClampMacro(ScatteringAnisotropy, double, -1.0, 1.0);
  vtkGetMacro(ScatteringAnisotropy, double);
  ///@}

  ///@{
  /**
   * Strength of ambient occlusion, [0, 1]: how much darker a place is that sees little of what is
   * around the volume. With the part V of the light from all around that matter within
   * AmbientOcclusionReach lets through, all light of a sample is multiplied by
   * V / (V + strength (1 - V)): at 1 light is reflected once, below that matter also reflects the
   * light of other matter. V is that two voxels outside the surface of a sample
   * (Documentation/Mathematics.md); a box of voxels without interpolation has that of its middle,
   * and with LabelSurfaces a label has a surface of its own; so has each of several components,
   * where the component changes that determines its opacity. The error tolerance holds for the
   * image with its occlusion, which needs one: without a tolerance, and below 1/128, it takes very
   * long. For composites, lit or not. Packets of rays on the processor draw it where they can (see
   * ProcessorMarching), also with a graphics card, and keep the light while the volume and its look
   * stay, in up to a byte for each voxel. Shaders draw the rest, such as gaps beside gradients, but
   * not volumes that do not fit into graphics memory; they compute all light again in each image.
   * Without a graphics card they may have to stop behind translucent matter; the mapper then warns
   * that the tolerance may be missed. Images during interaction (see MinimumImageSampleDistance)
   * leave occlusion out. Default: 0, no occlusion.
   */
  vtkSetClampMacro(AmbientOcclusion, double, 0.0, 1.0);
  vtkGetMacro(AmbientOcclusion, double);
  ///@}

  ///@{
  /**
   * Distance beyond which matter does not occlude [mm]. Default: 0, which is 16 times the smallest
   * distance between voxels.
   */
  vtkSetClampMacro(AmbientOcclusionReach, double, 0.0, 1e30);
  vtkGetMacro(AmbientOcclusionReach, double);
  ///@}

  enum TypesOfMask
  {
    BinaryMaskType,
    LabelMapMaskType
  };

  ///@{
  /**
   * An image of one component that spans the same box as the volume, at any resolution; each mask
   * voxel fills the cube around it. Default: none. As in vtkGPUVolumeRayCastMapper, a binary mask
   * limits all blend modes to where it is above 0. A label map (the default type) gives voxels the
   * transfer functions of their label (vtkVolumeProperty::SetLabelColor, SetLabelScalarOpacity,
   * SetLabelGradientOpacity), for composites of volumes of one component. Labels may have any
   * value; a voxel whose label has no function is drawn as if it had no label.
   */
  void SetMaskInput(vtkImageData* mask);
  vtkImageData* GetMaskInput();
  vtkSetClampMacro(MaskType, int, BinaryMaskType, LabelMapMaskType);
  vtkGetMacro(MaskType, int);
  void SetMaskTypeToBinary() { this->SetMaskType(BinaryMaskType); }
  void SetMaskTypeToLabelMap() { this->SetMaskType(LabelMapMaskType); }
  ///@}

  ///@{
  /**
   * Weight of the label's functions, [0, 1]; the volume's own functions have the rest. Default: 1.
   */
  vtkSetClampMacro(MaskBlendFactor, float, 0.0f, 1.0f);
  vtkGetMacro(MaskBlendFactor, float);
  ///@}

  ///@{
  /**
   * Light voxels with a label as the surface of their label, so that a segment in tissue of its own
   * brightness is not dark. Inside a label the light is that of a surface that faces the eye.
   * Default: off, lit by the gradient of the scalars, as VTK does.
   */
  vtkSetMacro(LabelSurfaces, vtkTypeBool);
  vtkGetMacro(LabelSurfaces, vtkTypeBool);
  vtkBooleanMacro(LabelSurfaces, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Name of the point data array that is the second argument of a two-dimensional transfer function
   * (vtkVolumeProperty::SetTransferFunction2D). Default: none, which means the gradient magnitude,
   * measured as for gradient opacity. The first and last points on each axis of the function's
   * image are the ends of that argument's range.
   */
  vtkSetStringMacro(Transfer2DYAxisArray);
  vtkGetStringMacro(Transfer2DYAxisArray);
  ///@}

protected:
  vtkMaterialVolumeMapper();
  ~vtkMaterialVolumeMapper() override;

  double NanColor[3] = { 0.5, 0.0, 0.0 };
  double NanOpacity = 0.0;
  vtkSmartPointer<vtkImageData> MaskInput;
  int MaskType = LabelMapMaskType;
  float MaskBlendFactor = 1.0f;
  vtkTypeBool LabelSurfaces = 0;
  char* Transfer2DYAxisArray = nullptr;
  double DampingGradient = 0.0;
  vtkTypeBool Shadows = 0;
  double ShadowStrength = 1.0;
  double VolumetricScatteringBlending = 0.0;
  double GlobalIlluminationReach = 0.0;
  double ScatteringAnisotropy = 0.0;
  double AmbientOcclusion = 0.0;
  double AmbientOcclusionReach = 0.0;

private:
  vtkMaterialVolumeMapper(const vtkMaterialVolumeMapper&) = delete;
  void operator=(const vtkMaterialVolumeMapper&) = delete;
};

#endif
