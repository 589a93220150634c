#include "Viewer/Model/Language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include <clocale>

// Q_INIT_RESOURCE must be used outside of namespaces.
static void InitTranslations()
{
  Q_INIT_RESOURCE(translations);
}

namespace varimarch
{

namespace
{

const QString LanguageKey = QStringLiteral("language");

}

QVector<Language> Languages()
{
  return { { "en", "English" }, { "de", "Deutsch" }, { "es", "Español" } };
}

QString ChosenLanguage()
{
  return QSettings().value(LanguageKey).toString();
}

void ChooseLanguage(const QString& code)
{
  QSettings().setValue(LanguageKey, code);
}

void Speak(const QString& code, QCoreApplication* application)
{
  InitTranslations();
  for (QTranslator* last : application->findChildren<QTranslator*>())
  {
    delete last;
  }
  const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
  QLocale::setDefault(locale);
  // Qt takes all of the desktop's locale, but readers of files expect numbers as in C.
  std::setlocale(LC_NUMERIC, "C");
  // Standard buttons such as "Cancel" are translated by Qt's own catalogue.
  const QString folderOfQt = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
  const std::pair<QString, QString> places[] = { { "qtbase", folderOfQt },
    { "varimarch", ":/translations" } };
  for (const auto& [name, folder] : places)
  {
    auto* const translator = new QTranslator(application);
    if (translator->load(locale, name, "_", folder))
    {
      QCoreApplication::installTranslator(translator);
    }
  }
}

}
