#include "Viewer/SaveDialog.h"

#include <QFileDialog>

namespace varimarch
{

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
