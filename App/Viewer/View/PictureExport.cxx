#include "Viewer/View/PictureExport.h"

#include "Scene/Images/ImageFiles.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/Overlay.h"
#include "Viewer/View/VtkPictures.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFile>
#include <QFormLayout>
#include <QMessageBox>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include <vtkCamera.h>

#include <exception>
#include <memory>

namespace varimarch
{

namespace
{

constexpr int MostPixelsPerSide = 16384;
// Text has the same size relative to the image; it is laid out for an image of this height.
constexpr double HeightOfWords = 800.0;

QImage OnBackground(const QImage& image, const std::array<double, 3>& rgb)
{
  QImage result(image.size(), QImage::Format_RGB32);
  result.fill(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
  QPainter(&result).drawImage(0, 0, image);
  return result;
}

void DrawNotice(QPainter& painter, const QSizeF& size)
{
  DrawLegibly(painter, QRectF(10.0, 0.0, size.width() - 20.0, size.height() - 8.0),
    Qt::AlignLeft | Qt::AlignBottom,
    QCoreApplication::translate("PictureExport", "Not for diagnostic use"));
}

Scene OfSize(Scene scene, const QSize& pixels)
{
  scene.size = { pixels.width(), pixels.height() };
  return scene;
}

template <class Named>
void ForgetNames(std::vector<Named>& all)
{
  for (Named& one : all)
  {
    one.name.clear();
  }
}

void ForgetFile(VolumeSource& volume)
{
  if (auto* const file = std::get_if<FileSource>(&volume))
  {
    file->path = "volume";
    file->series.clear();
  }
}

void ForgetOwnName(Look& look)
{
  if (!IsPresetName(look.name))
  {
    look.name.clear();
    look.description.clear();
  }
}

void ForgetNames(std::optional<SceneLabels>& labels)
{
  if (labels)
  {
    labels->path = "labels";
    labels->series.clear();
    ForgetNames(labels->segments);
  }
}

// The scene without paths and names given by the user, which may contain a patient's name.
std::string AnonymousText(Scene scene)
{
  ForgetFile(scene.volume);
  for (OverlaidVolume& overlay : scene.overlays)
  {
    ForgetFile(overlay.source);
    ForgetOwnName(overlay.look);
    ForgetNames(overlay.labels);
  }
  ForgetNames(scene.overlays);
  ForgetOwnName(scene.look);
  ForgetNames(scene.measures);
  ForgetNames(scene.keyImages);
  ForgetNames(scene.labels);
  return SceneText(scene);
}

}

PictureMaker::PictureMaker(const Scene& scene, const Study& study, const ExportOptions& options)
  : scene(OfSize(scene, options.pixels))
  , study(study)
  , options(options)
{
  const DrawingWithoutDisplay drawing;
  this->view.emplace(this->scene, study.volume.image, MapperKind::Varimarch);
  if (this->scene.labels)
  {
    this->view->Pipeline().SetLabels(study.labels);
    this->view->Pipeline().SetSegments(this->scene.labels->segments);
  }
  this->view->Pipeline().SetOverlays(this->scene.overlays, VoxelsOfOverlays(study));
}

PictureMaker::~PictureMaker()
{
  const DrawingWithoutDisplay drawing;
  this->view.reset();
}

QImage PictureMaker::Draw(const std::function<bool(double)>& onProgress)
{
  auto drawing = std::make_unique<DrawingWithoutDisplay>();
  std::function<bool(double)> tell;
  if (onProgress)
  {
    tell = [&](double part)
    {
      drawing.reset(); // for windows that draw meanwhile
      const bool goesOn = onProgress(part);
      drawing = std::make_unique<DrawingWithoutDisplay>();
      return goesOn;
    };
  }
  const vtkSmartPointer<vtkImageData> floats = this->view->FloatImage(tell);
  if (!floats)
  {
    return {};
  }
  QImage picture = ImageOfFloats(floats);
  if (!this->options.transparent)
  {
    picture = OnBackground(picture, this->scene.background);
  }
  const double scale = picture.height() / HeightOfWords;
  const QSizeF size = QSizeF(picture.size()) / scale;
  QPainter painter(&picture);
  painter.scale(scale, scale);
  if (this->options.overlay)
  {
    DrawOverlay(painter,
      { this->scene, MeasureTexts(this->scene, this->study), this->study.volume.image },
      FrameOf(this->view->Pipeline().Renderer()->GetActiveCamera(), size),
      this->view->Pipeline().Mask());
  }
  DrawNotice(painter, size);
  painter.end();
  picture.setText("varimarch-scene", QString::fromStdString(AnonymousText(this->scene)));
  return picture;
}

void PictureMaker::ShowTime(const Study& ofTime)
{
  const DrawingWithoutDisplay drawing;
  this->study = ofTime;
  std::get<FileSource>(this->scene.volume).time = ofTime.volume.times.current;
  this->view->Pipeline().SetImage(ofTime.volume.image);
  this->view->Pipeline().SetOverlays(this->scene.overlays, VoxelsOfOverlays(ofTime));
}

void PictureMaker::SetLook(const Look& look)
{
  const DrawingWithoutDisplay drawing;
  this->scene.look = look;
  this->view->Pipeline().SetLook(look);
}

void PictureMaker::SetCuts(const SceneCuts& cuts)
{
  const DrawingWithoutDisplay drawing;
  this->scene.cuts = cuts;
  this->view->Pipeline().SetCuts(cuts);
}

void PictureMaker::Turn(double degrees)
{
  vtkRenderer* const renderer = this->view->Pipeline().Renderer();
  renderer->GetActiveCamera()->Azimuth(degrees);
  renderer->ResetCameraClippingRange();
}

// QImage would not report that the last bytes, which are in a buffer, could not be written.
bool SaveAsPng(const QImage& picture, const std::string& path)
{
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG") && file.flush();
}

ExportDialog::ExportDialog(SceneModel* model, QSize viewSize, QWidget* parent)
  : QDialog(parent)
  , model(model)
  , width(new QSpinBox)
  , height(new QSpinBox)
  , transparent(new QCheckBox(tr("Transparent background (PNG)")))
  , overlay(new QCheckBox(tr("Directions and measurements")))
  , progress(new QProgressBar)
{
  this->setWindowTitle(tr("Export an image"));
  for (QSpinBox* side : { this->width, this->height })
  {
    side->setRange(16, MostPixelsPerSide);
    side->setSuffix(tr(" pixels"));
  }
  this->width->setValue(viewSize.width());
  this->height->setValue(viewSize.height());
  this->transparent->setObjectName("transparent");
  this->overlay->setChecked(true);
  this->progress->setRange(0, 100);
  this->progress->hide();
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  this->save = buttons->button(QDialogButtonBox::Save);
  auto* const layout = new QFormLayout(this);
  layout->addRow(tr("Width"), this->width);
  layout->addRow(tr("Height"), this->height);
  layout->addRow(this->transparent);
  layout->addRow(this->overlay);
  layout->addRow(this->progress);
  layout->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::Export);
  connect(buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
}

void ExportDialog::reject()
{
  if (this->exports)
  {
    this->exports = false;
  }
  else
  {
    QDialog::reject();
  }
}

bool ExportDialog::GoesOn(double part)
{
  this->progress->setValue(int(100.0 * part));
  QCoreApplication::processEvents();
  return this->exports;
}

void ExportDialog::Export()
{
  this->path = ChosenFileToSave(this, tr("Export an image"),
    { tr("PNG (*.png)"), tr("DICOM without data of the patient (*.dcm)") }, "picture");
  if (this->path.isEmpty())
  {
    return;
  }
  this->progress->show();
  this->save->setEnabled(false);
  this->exports = true;
  try
  {
    this->Write();
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot export"), QString::fromStdString(problem.what()));
  }
  this->exports = false;
  this->save->setEnabled(true);
  this->progress->hide();
}

// Scene and study are those of the beginning: others may come while windows draw.
void ExportDialog::Write()
{
  const std::string file = this->path.toStdString();
  const bool isTransparent =
    this->transparent->isChecked() && PictureFormatOf(file) == PictureFormat::Png;
  this->model->CountSegments();
  const Scene scene = this->model->CurrentScene();
  const auto study = ShownStudy(*this->model);
  PictureMaker maker(scene, *study,
    { { this->width->value(), this->height->value() }, isTransparent, this->overlay->isChecked() });
  const QImage picture = maker.Draw([this](double part) { return this->GoesOn(part); });
  if (picture.isNull())
  {
    return;
  }
  WritePicture(BytesOfImage(picture),
    { scene.render, MapperKind::Varimarch, picture.text("varimarch-scene").toStdString(), {},
      study->volume.isPreview },
    file);
  this->accept();
}

}
