#include "Viewer/Reports/ScanReport.h"

#include "Scene/Presets.h"
#include "Scene/SceneNames.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Reports/PdfPages.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/SliceView.h"

#include <QCoreApplication>
#include <QTextDocument>
#include <QUrl>

#include <cmath>

namespace varimarch
{

namespace
{

const QSize PictureSize(1200, 900);
const QSize SliceSize(480, 420);
// Width of an image that fills an A4 page between its margins [1/96 inch].
constexpr int WidthOnPage = 640;

QString Translated(const char* text)
{
  return QCoreApplication::translate("ScanReport", text);
}

QString Number(double number, int decimals)
{
  return QString::number(number, 'f', decimals);
}

QString Row(const QString& name, const QString& value)
{
  return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
}

// Names of the user's own looks are left out; they may contain a patient's name.
QString NameOf(const Look& look, const ImageStatistics& statistics)
{
  const QString name = QString::fromStdString(look.name);
  return !IsPresetName(look.name)     ? Translated("custom look")
    : IsBuiltInLook(look, statistics) ? name
                                      : Translated("%1, edited").arg(name);
}

QString LightText(const Shading& shading)
{
  return shading.enabled ? Translated("ambient %1, diffuse %2, specular %3, power %4")
                             .arg(Number(shading.ambient, 2), Number(shading.diffuse, 2),
                               Number(shading.specular, 2), Number(shading.specularPower, 0))
                         : Translated("none: unshaded colours");
}

QString ErrorText(const RenderOptions& render)
{
  return render.errorTolerance > 0.0
    ? Translated("at most 1/%1 of full brightness in any colour of 99.9 % of the pixels, estimated")
        .arg(int(std::lround(1.0 / render.errorTolerance)))
    : Translated("not bounded");
}

QString VolumeRows(const LoadedVolume& volume)
{
  const int* const count = volume.image->GetDimensions();
  const double* const spacing = volume.image->GetSpacing();
  const QString modality =
    volume.modality.empty() ? Translated("unknown") : QString::fromStdString(volume.modality);
  return Row(Translated("Modality"), modality) +
    Row(Translated("Voxels"), QString("%1 x %2 x %3").arg(count[0]).arg(count[1]).arg(count[2])) +
    Row(Translated("Voxel spacing"),
      QString("%1 x %2 x %3 mm")
        .arg(Number(spacing[0], 3), Number(spacing[1], 3), Number(spacing[2], 3)));
}

QString SettingRows(const Scene& scene, const ImageStatistics& statistics)
{
  return Row(Translated("Look"), NameOf(scene.look, statistics)) +
    Row(Translated("Blend mode"), QString::fromStdString(NameOf(BlendNames(), scene.look.blend))) +
    Row(Translated("Opacity per"), Number(scene.look.opacityUnitDistanceMm, 2) + " mm") +
    Row(Translated("Opacity by gradient"),
      scene.look.gradientOpacities.empty() ? Translated("off") : Translated("on")) +
    Row(Translated("Light"), LightText(scene.look.shading)) +
    Row(Translated("Cut planes"), QString::number(scene.cuts.planes.size())) +
    Row(Translated("Scissors cuts"), QString::number(scene.cuts.scissors.size())) +
    Row(Translated("Promised error"), ErrorText(scene.render));
}

// Names of measurements are left out; they may contain a patient's name.
QString MeasureRows(const Scene& scene, const Study& study)
{
  const MeasureTexts texts(scene, study.volume);
  QString rows;
  const auto add = [&](const QString& kind, const QStringList& measures)
  {
    for (int i = 0; i < measures.size(); ++i)
    {
      rows += Row(QString("%1 %2").arg(kind).arg(i + 1), measures[i]);
    }
  };
  add(Translated("Distance"), texts.distances);
  add(Translated("Angle"), texts.angles);
  add(Translated("Box"), texts.boxes);
  return rows.isEmpty() ? Row(Translated("Measurements"), Translated("none")) : rows;
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

}

QString ScanReportHtml(const Scene& scene, const Study& study)
{
  return QStringLiteral("<h1>%1</h1>%2<p><img src='picture' width='%9'></p>"
                        "<p><img src='axial' width='%10'> <img src='coronal' width='%10'> "
                        "<img src='sagittal' width='%10'></p>"
                        "<h3>%3</h3><table>%4</table><h3>%5</h3><table>%6</table>"
                        "<h3>%7</h3><table>%8</table>")
    .arg(Translated("Volume report"), OriginHtml(), Translated("Volume"), VolumeRows(study.volume),
      Translated("Rendering settings"), SettingRows(scene, study.statistics),
      Translated("Measurements"), MeasureRows(scene, study))
    .arg(WidthOnPage)
    .arg((WidthOnPage - 10) / 3);
}

void WriteScanReport(SceneModel* model, const QString& path)
{
  const Scene& scene = model->CurrentScene();
  QTextDocument document;
  AddSlices(document, model);
  PictureMaker maker(scene, model->CurrentStudy()->volume, { PictureSize, false, true });
  AddPicture(document, "picture", maker.Draw());
  document.setHtml(ScanReportHtml(scene, *model->CurrentStudy()));
  WritePdf(document, Translated("Volume report"), path);
}

}
