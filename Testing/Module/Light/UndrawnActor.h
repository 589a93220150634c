#ifndef Varimarch_Testing_UndrawnActor_h
#define Varimarch_Testing_UndrawnActor_h

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

/// An actor that casts shadows and is not in the image, which then shows nothing but a volume.
class UndrawnActor : public vtkActor
{
public:
  static UndrawnActor* New() { VTK_STANDARD_NEW_BODY(UndrawnActor); }
  vtkTypeMacro(UndrawnActor, vtkActor);

  static vtkSmartPointer<vtkActor> Of(vtkMapper* mapper)
  {
    const auto actor = vtkSmartPointer<UndrawnActor>::New();
    actor->SetMapper(mapper);
    return actor;
  }

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
};

#endif
