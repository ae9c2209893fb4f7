// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/StampAction.h"

#include "document/volume/BrushStampReader.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/tools/ToolHost.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

StampAction::StampAction(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_action(tr("Load s&tamp…"), this) {
  prepare(m_action, "volumeStamp", nullptr,
          tr("Shape clay by the brightness of a picture, or by the height of a part"));
  m_action.setEnabled(false);
  connect(&m_action, &QAction::triggered, this, &StampAction::ask);
}

void StampAction::setDocument(DocumentTab* document) {
  m_document = document;
  m_action.setEnabled(document != nullptr);
}

ClayTool::StampServices StampAction::services() {
  return {m_stamps, [this] { ask(); }};
}

void StampAction::ask() {
  QStringList filters = openFilters(m_parts.kinds);
  filters.prepend(tr("Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.pgm *.ppm *.pbm)"));
  auto* const dialog =
      openingDialog(m_parts.window, m_document->document, tr("Load a stamp"), filters.join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("stampDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (document == m_document) load(path);
  });
  dialog->open();
}

void StampAction::load(const QString& path) {
  Job job;
  job.name = tr("Loading a stamp");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.work = [this, path, document = m_document](Progress progress) -> Job::Finish {
    const std::filesystem::path file(QFile::encodeName(path).toStdString());
    const auto stamp = readBrushStamp(file, m_parts.kinds, progress);
    return [this, path, document, stamp] {
      if (!stamp) {
        if (stamp.error().code != ErrorCode::Cancelled)
          emit message({Message::Weight::Error, tr("The stamp cannot be loaded"), errorSentence(stamp.error()),
                        errorAdvice(stamp.error())});
        return;
      }
      const std::size_t number = m_stamps->add(QFileInfo(path).fileName().toStdString(), *stamp);
      if (document == m_document) use(number);
    };
  };
  m_parts.jobs.start(std::move(job));
}

// Keeps the action of the tool, unless it has no stamps.
void StampAction::use(std::size_t number) {
  const ToolRunner& runner = m_parts.tools.runner();
  if (!dynamic_cast<const ClayTool*>(runner.tool())) m_parts.chooseTool(QStringLiteral("clayTool"));
  if (!runner.tool()) return;
  const std::vector<Property> settings = runner.tool()->settings();
  const auto isStamp = [](const Property& setting) { return setting.id == "stamp"; };
  if (std::none_of(settings.begin(), settings.end(), isStamp))
    m_parts.tools.choose("clay", "action", static_cast<double>(ClayAction::Add));
  m_parts.tools.choose("clay", "stamp", static_cast<double>(number));
}

}  // namespace handwheel
