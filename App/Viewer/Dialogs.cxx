#include "Viewer/Dialogs.h"

#include <QColorDialog>
#include <QFileDialog>

namespace varimarch
{

QColorDialog* OpenLiveColorDialog(
  const QColor& color, const std::function<void(const QColor&)>& changed, QWidget* parent)
{
  auto* const dialog = new QColorDialog(color, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  QObject::connect(dialog, &QColorDialog::currentColorChanged, parent, changed);
  dialog->open();
  return dialog;
}

QString ChosenFileToSave(
  QWidget* parent, const QString& title, const QStringList& filters, const QString& name)
{
  QFileDialog dialog(parent, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  const auto takeExtension = [&dialog](const QString& filter)
  { dialog.setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0)); };
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, takeExtension);
  dialog.setNameFilters(filters);
  takeExtension(filters.first());
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().first() : QString();
}

}
