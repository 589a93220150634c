#include "Viewer/LiveColorDialog.h"

#include <QColorDialog>

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

}
