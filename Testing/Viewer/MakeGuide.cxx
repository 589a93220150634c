// Works through Documentation/UserGuide.md in the viewer, and makes the guide's images.
//
// Usage: ViewerGuide HEAD_CT FOLDER, on a display; writes viewer-*.png into the folder.

#include "LeaksOfOthers.h"
#include "PrivateSettings.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "Viewer/MainWindow.h"
#include "Viewer/RegionEditor/RegionEditor.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/VolumeView.h"

#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

using namespace varimarch;

namespace
{

constexpr int MostMilliseconds = 120000;

void Require(bool done, const char* what)
{
  if (!done)
  {
    throw std::runtime_error(what);
  }
}

// Labels by values in HU: 1 in bone, and 2 in the teeth, which lie in the lowest slices.
vtkSmartPointer<vtkImageData> BoneAndTeeth(vtkImageData* scan)
{
  auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->CopyStructure(scan);
  labels->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const label = static_cast<unsigned char*>(labels->GetScalarPointer());
  vtkDataArray* const values = scan->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = values->GetComponent(i, 0);
    label[i] = value > 600.0 && 10 * i < count ? 2 : value > 250.0 ? 1 : 0;
  }
  return labels;
}

class Guide
{
public:
  Guide(const QString& scan, const QString& folder)
    : folder(folder)
  {
    this->window.resize(1280, 800);
    this->window.show();
    this->window.Open(scan);
    Require(
      QTest::qWaitFor([&] { return this->Model()->CurrentStudy() != nullptr; }, MostMilliseconds),
      "the scan is not opened");
    this->Take("viewer-first-picture");
  }

  void SeeSurfaces()
  {
    Look look = this->Model()->CurrentScene().look;
    look.blend = Blend::Isosurface;
    look.isosurfaces = { { -300.0, { 0.87, 0.66, 0.53 }, 0.25 },
      { 350.0, { 0.95, 0.90, 0.78 }, 1.0 } };
    this->window.findChild<QDockWidget*>("look")->raise();
    this->Model()->SetLook(look, "isosurfaces");
    this->Take("viewer-surfaces");
    this->Model()->History()->undo();
  }

  // Skin and bone by their edges.
  void SeeRegions()
  {
    auto* const dock = this->window.findChild<QDockWidget*>("look");
    auto* const isOn = dock->findChild<QCheckBox*>("regions");
    Require(QTest::qWaitFor([&] { return isOn->isEnabled(); }, MostMilliseconds),
      "the gradients are not counted");
    Look look = this->Model()->CurrentScene().look;
    look.regions = { { RegionShape::Rectangle, { -700.0, -150.0 }, { 150.0, 500.0 },
                       { 0.87, 0.66, 0.53 }, 0.06, 0.5 },
      { RegionShape::Ellipse, { 150.0, 1100.0 }, { 60.0, 500.0 }, { 0.95, 0.90, 0.78 }, 0.7,
        0.3 } };
    this->Model()->SetLook(look, "regions");
    auto* const editor = dock->findChild<RegionEditor*>();
    editor->Select(1);
    QTest::qWait(100); // until the panel has its height
    dock->findChild<QScrollArea*>()->ensureWidgetVisible(editor->parentWidget());
    this->Take("viewer-regions");
    this->Model()->History()->undo();
  }

  void CutAway()
  {
    this->window.findChild<QDockWidget*>("cuts")->raise();
    this->window.findChild<QToolButton*>("addPlane")->menu()->actions().first()->trigger();
    this->Model()->Edit(ScenePart::Camera, "turn the camera",
      [](Scene& scene)
      {
        scene.camera.azimuthDegrees = 50.0;
        scene.camera.elevationDegrees = 15.0;
      });
    this->Take("viewer-cut");
  }

  // Cuts away the head rest, on both sides of the head.
  void CutOut()
  {
    this->Model()->History()->undo();
    this->Model()->History()->undo();
    VolumeView* const view = this->window.CentralView()->Ours();
    const QPointF middle = QRectF(view->rect()).center();
    const double unit = 0.011 * std::min(view->width(), view->height()); // the head fits into both
    view->SetTool(LeftButton::KeepOnly);
    const QPointF outline[] = { { -15, 40 }, { -19, 15 }, { -20, 0 }, { -18, -16 }, { -8, -25 },
      { 8, -25 }, { 18, -16 }, { 20, 0 }, { 19, 15 }, { 15, 40 } };
    const auto place = [&](const QPointF& point) { return (middle + unit * point).toPoint(); };
    QTest::mousePress(view, Qt::LeftButton, {}, place(outline[0]));
    for (const QPointF& point : outline)
    {
      QTest::mouseMove(view, place(point));
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, place(outline[9]));
    view->SetTool(LeftButton::Turn);
    Require(this->Model()->CurrentScene().cuts.scissors.size() == 1, "nothing is cut out");
    this->Take("viewer-scissors");
  }

  void MeasureDistance()
  {
    this->window.findChild<QDockWidget*>("measures")->raise();
    VolumeView* const view = this->window.CentralView()->Ours();
    view->SetTool(LeftButton::Distance);
    const QPoint from = view->rect().center() + QPoint(-40, -90);
    const QPoint to = view->rect().center() + QPoint(90, 10);
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    QTest::mouseMove(view, to);
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
    view->SetTool(LeftButton::Turn);
    Require(this->Model()->CurrentScene().measures.size() == 1, "no distance is measured");
    this->Take("viewer-distance");
  }

  void ShowSegments()
  {
    const QTemporaryDir place;
    const std::string path = place.filePath("segments.nrrd").toStdString();
    WriteVolume({ BoneAndTeeth(this->Model()->CurrentStudy()->volume.image), "", {} }, path);
    VolumeView* const view = this->window.CentralView()->Ours();
    view->SetRefining(false); // one frame is enough
    this->window.Loader()->StartLabels(
      { path, {}, { { 1, "bone", { 0.90, 0.60, 0.25 } }, { 2, "teeth", { 0.25, 0.60, 0.95 } } } },
      0);
    Require(QTest::qWaitFor(
              [&] { return this->Model()->CurrentStudy()->labels != nullptr; }, MostMilliseconds),
      "the segments are not opened");
    this->Take("viewer-segments");
    this->Model()->History()->undo();
    view->SetRefining(true);
  }

  void CompareWithVtk()
  {
    ComparisonView* const view = this->window.CentralView();
    QSignalSpy compared(view, &ComparisonView::Compared);
    this->window.Compare(MapperKind::VtkGpu);
    Require(compared.wait(MostMilliseconds), "the pictures are not compared");
    this->Take("viewer-comparison");
    this->window.Compare(std::nullopt);
  }

  void Export()
  {
    PictureMaker maker(
      this->Model()->CurrentScene(), *this->Model()->CurrentStudy(), { { 640, 480 }, false, true });
    Require(maker.Draw().save(this->folder + "/viewer-export.png"), "the picture is not written");
  }

private:
  SceneModel* Model() { return this->window.Model(); }

  // Waits until the view has stopped refining, then saves it.
  void Take(const QString& name)
  {
    VolumeView* const view = this->window.CentralView()->Ours();
    auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(view->Pipeline()->Mapper());
    QSignalSpy drawn(view, &VolumeView::Drawn);
    int before = -1;
    while (before != drawn.count() || mapper->GetDrawnPart() < 1.0)
    {
      before = drawn.count();
      QTest::qWait(1500);
    }
    Require(this->window.grab().save(this->folder + "/" + name + ".png"),
      "the window's picture is not written");
  }

  QString folder;
  MainWindow window;
};

}

int main(int argumentCount, char** arguments)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const PrivateSettings settings;
  QApplication application(argumentCount, arguments);
  if (argumentCount != 3)
  {
    std::cerr << "Usage: ViewerGuide HEAD_CT FOLDER\n";
    return 2;
  }
  try
  {
    Guide guide(arguments[1], arguments[2]);
    guide.SeeSurfaces();
    guide.SeeRegions();
    guide.CutAway();
    guide.CutOut();
    guide.ShowSegments();
    guide.MeasureDistance();
    guide.CompareWithVtk();
    guide.Export();
    return 0;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "ViewerGuide: " << problem.what() << '\n';
    return 1;
  }
}
