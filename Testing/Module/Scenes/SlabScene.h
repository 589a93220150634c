#ifndef Varimarch_Testing_SlabScene_h
#define Varimarch_Testing_SlabScene_h

#include "Module/Scenes/MapperScene.h"

/// A slab of 40 x 40 x 8 mm, from z = 0, of the same material everywhere. Its values fall along z,
/// so that all normals point along z. The eye looks down onto it.
struct SlabScene : MapperScene
{
  /// @param red  of its colour, whose green is 0.4 and whose blue is 0.2
  SlabScene(double opacityPerMm, double red)
    : MapperScene(FallingValues(), 9)
  {
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, red, 0.4, 0.2);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.0, opacityPerMm);
    this->LookDown({ 0.0, 0.0, 0.0 }, 0.5);
  }

  /// Gives the slab diffuse light and shadows, and the renderer no light.
  void LightDiffusely()
  {
    vtkVolumeProperty* const property = this->volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    this->renderer->AutomaticLightCreationOff();
    this->renderer->RemoveAllLights();
    this->mapper->ShadowsOn();
  }

private:
  static vtkSmartPointer<vtkImageData> FallingValues()
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, 9);
    image->SetOrigin(-20.0, -20.0, 0.0);
    image->SetSpacing(5.0, 5.0, 1.0);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 9 * 9 * 9; ++i)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[i] =
        static_cast<unsigned char>(80 - 10 * (i / (9 * 9)));
    }
    return image;
  }
};

#endif
