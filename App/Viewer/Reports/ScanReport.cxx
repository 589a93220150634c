#include "Viewer/Reports/ScanReport.h"

#include "DicomMeasures/DicomMeasures.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/Placing.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/SliceView.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace varimarch
{

namespace
{

const QSize PictureSize(1200, 900);
const QSize SliceSize(480, 420);
// Widths on an A4 page, which is 640 wide between its margins [1/96 inch]. Three slices beside the
// image are as high as it is, and leave room for the settings and a few measurements.
constexpr int WidthOfPicture = 460;
constexpr int WidthOfSlice = 130;

// A class, since lupdate finds only the texts that are arguments of tr.
class ReportTexts
{
  Q_DECLARE_TR_FUNCTIONS(ScanReport)
};

QString Row(const QString& name, const QString& value)
{
  return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
    .arg(name.toHtmlEscaped(), value.toHtmlEscaped().replace('\n', "<br>"));
}

// Names of the user's own looks are left out; they may contain a patient's name.
QString NameOf(const Look& look, const ImageStatistics& statistics)
{
  const QString name = QString::fromStdString(look.name);
  return !IsPresetName(look.name)     ? ReportTexts::tr("custom look")
    : IsBuiltInLook(look, statistics) ? name
                                      : ReportTexts::tr("%1, edited").arg(name);
}

QString LightText(const Shading& shading)
{
  return shading.enabled
    ? ReportTexts::tr("ambient %1, diffuse %2, specular %3, power %4")
        .arg(NumberText(shading.ambient, 2), NumberText(shading.diffuse, 2),
          NumberText(shading.specular, 2), NumberText(shading.specularPower, 0))
    : ReportTexts::tr("none: unshaded colours");
}

QString ErrorText(const RenderOptions& render, const LoadedVolume& volume)
{
  return render.errorTolerance > 0.0 && !volume.isPreview
    ? ReportTexts::tr(
        "at most 1/%1 of full brightness in any colour of 99.9 % of the pixels, estimated")
        .arg(int(std::lround(1.0 / render.errorTolerance)))
    : ReportTexts::tr("not bounded");
}

QString VolumeRows(const LoadedVolume& volume)
{
  const int* const count = volume.image->GetDimensions();
  const double* const spacing = volume.image->GetSpacing();
  const QString modality =
    volume.modality.empty() ? ReportTexts::tr("unknown") : QString::fromStdString(volume.modality);
  const QString voxels = QString("%1 x %2 x %3").arg(count[0]).arg(count[1]).arg(count[2]);
  return Row(ReportTexts::tr("Modality"), modality) +
    Row(ReportTexts::tr("Voxels"),
      volume.isPreview ? ReportTexts::tr("%1, a coarse copy of the volume").arg(voxels) : voxels) +
    Row(ReportTexts::tr("Voxel spacing"),
      QString("%1 x %2 x %3 mm")
        .arg(NumberText(spacing[0], 3), NumberText(spacing[1], 3), NumberText(spacing[2], 3)));
}

QString SettingRows(const Scene& scene, const Study& study)
{
  return Row(ReportTexts::tr("Look"), NameOf(scene.look, study.statistics)) +
    Row(ReportTexts::tr("Blend mode"),
      QString::fromStdString(NameOf(BlendNames(), scene.look.blend))) +
    Row(ReportTexts::tr("Opacity per"), NumberText(scene.look.opacityUnitDistanceMm, 2) + " mm") +
    Row(ReportTexts::tr("Opacity by gradient"),
      scene.look.gradientOpacities.empty() ? ReportTexts::tr("off") : ReportTexts::tr("on")) +
    Row(ReportTexts::tr("Light"), LightText(scene.look.shading)) +
    Row(ReportTexts::tr("Cut planes"), QString::number(scene.cuts.planes.size())) +
    Row(ReportTexts::tr("Scissors cuts"), QString::number(scene.cuts.scissors.size())) +
    Row(ReportTexts::tr("Table and clothes"),
      scene.cuts.bodyOnly ? ReportTexts::tr("removed") : ReportTexts::tr("shown")) +
    Row(ReportTexts::tr("Promised error"), ErrorText(scene.render, study.volume));
}

// Names of measurements are left out; they may contain a patient's name. The words of annotations
// are what they say.
Scene WithoutNames(Scene scene)
{
  for (Measure& measure : scene.measures)
  {
    if (!TraitsOf(measure.kind).hasWords)
    {
      measure.name.clear();
    }
  }
  return scene;
}

QString MeasureRows(const Scene& scene, const Study& study)
{
  const MeasureTexts texts(scene, study);
  QString rows;
  for (int i = 0; i < texts.values.size(); ++i)
  {
    rows += Row(QString("%1. %2").arg(i + 1).arg(TitleOf(scene.measures[i].kind)), texts.values[i]);
  }
  return rows.isEmpty() ? Row(ReportTexts::tr("Measurements"), ReportTexts::tr("none")) : rows;
}

// Unlike the names of measurements, those of segments are needed, and usually anatomy.
QString SegmentTable(const Scene& scene, const Study& first, int volume)
{
  const auto& labels = SceneLabelsOf(scene, volume);
  if (!labels)
  {
    return {};
  }
  const Study& study = StudyOfVolume(first, volume);
  QString rows;
  for (std::size_t i = 0; i < labels->segments.size(); ++i)
  {
    const Segment& segment = labels->segments[i];
    const QColor color = QColor::fromRgbF(segment.rgb.r, segment.rgb.g, segment.rgb.b);
    const QString name = QString::fromStdString(segment.name).toHtmlEscaped();
    QString text = RegionText(study.segmentStatistics[i], study.volume).toHtmlEscaped();
    rows += QStringLiteral("<tr><td bgcolor='%1'>&nbsp;&nbsp;&nbsp;&nbsp;</td>"
                           "<td>&nbsp;%2&nbsp;&nbsp;</td><td>%3</td></tr>")
              .arg(color.name(), name, text.replace('\n', "<br>"));
  }
  const QString title = volume == 0 ? ReportTexts::tr("Segments")
                                    : ReportTexts::tr("Segments of volume %1").arg(volume + 1);
  return QStringLiteral("<h3>%1</h3><table>%2</table>").arg(title, rows);
}

QString SegmentTables(const Scene& scene, const Study& study)
{
  QString tables;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    tables += SegmentTable(scene, study, volume);
  }
  return tables;
}

void AddPicture(QTextDocument& document, const QString& name, const QImage& image)
{
  document.addResource(QTextDocument::ImageResource, QUrl(name), image);
}

// Adds the slices as the window shows them.
void AddSlices(QTextDocument& document, SceneModel* model)
{
  const std::pair<QString, SlicePlane> planes[] = { { "axial", SlicePlane::Axial },
    { "coronal", SlicePlane::Coronal }, { "sagittal", SlicePlane::Sagittal } };
  for (const auto& [name, plane] : planes)
  {
    SliceView view(model, plane);
    view.resize(SliceSize);
    AddPicture(document, name, view.grab().toImage());
  }
}

// Gives views a scene to show. Restored segments look as they did in their file.
void ShowIn(SceneModel& model, const Scene& scene, const std::shared_ptr<const Study>& study)
{
  model.Restore(scene, study);
  model.Edit(ScenePart::Volume, {}, [&](Scene& restored) { restored = scene; });
}

// The scene as it was when a key image was marked.
Scene MarkedScene(const Scene& scene, const KeyImage& image, const LoadedTimes& times)
{
  Scene marked = scene;
  marked.slices = image.slices;
  marked.camera = image.camera;
  if (IsAtTime(image, times))
  {
    std::get<FileSource>(marked.volume).time = *image.time;
  }
  return marked;
}

// The study is that of the time of the key image.
QImage PictureOf(
  const KeyImage& image, const Scene& shown, const std::shared_ptr<const Study>& study)
{
  const Scene scene = MarkedScene(shown, image, study->volume.times);
  if (image.view == KeyView::Volume)
  {
    return PictureMaker(scene, *study, { PictureSize, false, true }).Draw();
  }
  SceneModel marked;
  ShowIn(marked, scene, study);
  SliceView view(&marked, SlicePlane(int(image.view) - int(KeyView::Axial)));
  view.resize(SliceSize);
  return view.grab().toImage();
}

QString NameOfKeyImage(std::size_t number)
{
  return QStringLiteral("key-image-%1").arg(number);
}

void AddKeyImages(QTextDocument& document, SceneModel* model)
{
  std::size_t number = 0;
  const Scene& scene = model->CurrentScene();
  const int shownTime = model->ChosenTime();
  StudyTimes times(scene, model->CurrentStudy());
  for (const KeyImage& image : scene.keyImages)
  {
    const bool hasTime = IsAtTime(image, model->CurrentStudy()->volume.times);
    const auto study = times.Read(hasTime ? *image.time : shownTime);
    AddPicture(document, NameOfKeyImage(++number), PictureOf(image, scene, study));
  }
}

// Names of key images are left out; they may contain a patient's name.
QString KeyImagesHtml(const std::vector<KeyImage>& images, const LoadedTimes& times)
{
  QString html;
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    const QString time = TimeTextOf(images[i], times);
    const QString title = TitleOf(images[i].view) + (time.isEmpty() ? "" : ", " + time);
    html += QStringLiteral("<p>%1. %2<br><img src='%3' width='%4'></p>")
              .arg(i + 1)
              .arg(title.toHtmlEscaped(), NameOfKeyImage(i + 1))
              .arg(WidthOfPicture);
  }
  return html.isEmpty() ? html
                        : QStringLiteral("<h3>%1</h3>").arg(ReportTexts::tr("Key images")) + html;
}

}

QString ScanReportHtml(const Scene& scene, const Study& study)
{
  return QStringLiteral("<h1>%1</h1>%2<table><tr><td><img src='picture' width='%9'></td>"
                        "<td><img src='axial' width='%10'><br><img src='coronal' width='%10'><br>"
                        "<img src='sagittal' width='%10'></td></tr></table>"
                        "<h3>%3</h3><table>%4</table><h3>%5</h3><table>%6</table>"
                        "<h3>%7</h3><table>%8</table>%11")
    .arg(ReportTexts::tr("Volume report"), OriginHtml(), ReportTexts::tr("Volume"),
      VolumeRows(study.volume), ReportTexts::tr("Rendering settings"), SettingRows(scene, study),
      ReportTexts::tr("Measurements"), MeasureRows(scene, study))
    .arg(WidthOfPicture)
    .arg(WidthOfSlice)
    .arg(SegmentTables(scene, study) + KeyImagesHtml(scene.keyImages, study.volume.times));
}

void WriteScanReport(SceneModel* model, const QString& path)
{
  SceneModel shown;
  ShowIn(shown, WithoutNames(model->CurrentScene()), ShownStudy(*model));
  shown.CountSegments();
  const Scene& scene = shown.CurrentScene();
  const std::shared_ptr<const Study> study = shown.CurrentStudy();
  QTextDocument document;
  AddSlices(document, &shown);
  AddKeyImages(document, &shown);
  PictureMaker maker(scene, *study, { PictureSize, false, true });
  AddPicture(document, "picture", maker.Draw());
  document.setHtml(ScanReportHtml(scene, *study));
  WritePdf(document, ReportTexts::tr("Volume report"), path);
}

namespace
{

constexpr int DotsPerInch = 150;
constexpr double MarginMm = 18.0;
constexpr double FootHeight = 40.0; // [dots]

void PaintFoot(QPainter& painter, const QSizeF& page, int number, int count)
{
  const QRectF foot(0.0, page.height() + 0.25 * FootHeight, page.width(), 0.75 * FootHeight);
  painter.setPen(Qt::darkGray);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
    QCoreApplication::translate(
      "PdfPages", "Not for diagnostic use: made by a program that is not a medical device"));
  painter.drawText(
    foot, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("%1 / %2").arg(number).arg(count));
}

void PaintPages(QTextDocument& document, QPdfWriter& writer)
{
  QPainter painter(&writer);
  const QSizeF page(writer.width(), writer.height() - FootHeight);
  document.documentLayout()->setPaintDevice(&writer);
  document.setDocumentMargin(0.0);
  document.setPageSize(page);
  for (int i = 0; i < document.pageCount(); ++i)
  {
    if (i > 0)
    {
      writer.newPage();
    }
    painter.save();
    painter.translate(0.0, -i * page.height());
    document.drawContents(&painter, QRectF(0.0, i * page.height(), page.width(), page.height()));
    painter.restore();
    PaintFoot(painter, page, i + 1, document.pageCount());
  }
}

}

void WritePdf(QTextDocument& document, const QString& title, const QString& path)
{
  WriteFileWhole(path.toStdString(),
    [&](const std::string& part)
    {
      QFile file(QString::fromStdString(part));
      if (!file.open(QIODevice::WriteOnly))
      {
        return false;
      }
      {
        QPdfWriter writer(&file);
        writer.setTitle(title);
        writer.setCreator("Varimarch");
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(
          QMarginsF(MarginMm, MarginMm, MarginMm, MarginMm), QPageLayout::Millimeter);
        writer.setResolution(DotsPerInch);
        PaintPages(document, writer);
      }
      // QPdfWriter reports no errors; those of the file remain set.
      return file.flush() && file.error() == QFile::NoError;
    });
}

QString OriginHtml()
{
  return QStringLiteral("<p>Varimarch %1, %2</p>")
    .arg(QCoreApplication::applicationVersion(),
      QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat));
}

bool MeasureReport::IsPossible(const Scene& scene, const Study& study, int volume)
{
  return !StudyOfVolume(study, volume).volume.frameOfReference.empty() &&
    std::holds_alternative<FileSource>(VolumeSourceOf(scene, volume));
}

MeasureReport::MeasureReport(const Scene& scene, const Study& shown, int volume)
  : scan(std::get<FileSource>(VolumeSourceOf(scene, volume)))
  , volume(StudyOfVolume(shown, volume).volume)
{
  const Placement placement = PlacementOf(scene, volume);
  const bool hasBox = std::any_of(scene.measures.begin(), scene.measures.end(),
    [](const Measure& measure) { return measure.kind == MeasureKind::Box; });
  if (hasBox && !AreTurnedAlike(shown.volume.image, Placed(this->volume.image, placement)))
  {
    throw std::runtime_error(QCoreApplication::translate("MeasureReport",
      "A box lies along the axes of the first scan, and this one has others. "
      "Remove the boxes, or save a table.")
                               .toStdString());
  }
  this->measures = InPatientCoordinates(scene.measures, placement, this->volume.image);
  this->volume.image = SharedCopy(this->volume);
}

void MeasureReport::Write(const std::string& path, const TaskProgress& goesOn) const
{
  ReadProgress progress(goesOn);
  const TaggedSeries images(this->scan.path, this->scan.series, progress);
  WriteDicomMeasures(this->measures, this->volume, images.Files(), path);
}

}
