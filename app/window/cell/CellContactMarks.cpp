// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellContactMarks.h"

#include "viewport/Viewport.h"
#include "viewport/path/ContactLayer.h"
#include "window/ActionToolTip.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kMostMarked = 100;  // more could not be distinguished

}  // namespace

CellContactMarks::CellContactMarks(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_layer(std::make_shared<ContactLayer>()),
      m_action(tr("Show where things to&uch"), this),
      m_finding(JobRunner::Policy::Latest, parts.pool) {
  prepare(m_action, "showContacts", nullptr,
          tr("Mark the places where links and bodies collide, with the way out of each other"));
  m_action.setCheckable(true);
  m_action.setChecked(true);
  parts.viewport.addLayer(m_layer);
  connect(&m_action, &QAction::toggled, this, &CellContactMarks::look);
}

CellContactMarks::~CellContactMarks() {
  m_parts.viewport.removeLayer(*m_layer);
}

void CellContactMarks::setVisible(bool isVisible) {
  m_layer->setVisible(isVisible);
}

void CellContactMarks::show(Source source, Collisions collisions) {
  std::erase_if(collisions, [](const CellCollision& each) { return each.pairs.empty(); });
  m_sources[static_cast<std::size_t>(source)] = std::move(collisions);
  look();
}

void CellContactMarks::clear(Source source) {
  if (!m_sources[static_cast<std::size_t>(source)]) return;
  m_sources[static_cast<std::size_t>(source)].reset();
  look();
}

void CellContactMarks::clearAll() {
  ++m_cell;
  m_sources = {};
  look();
}

// Null: nothing is marked.
const CellContactMarks::Collisions* CellContactMarks::shown() const {
  const auto first = std::find_if(m_sources.rbegin(), m_sources.rend(), [](const auto& each) { return each; });
  return m_action.isChecked() && first != m_sources.rend() && !(*first)->empty() ? &**first : nullptr;
}

// While one is being looked at the marks of the one before stay: they are hardly older than what is shown.
void CellContactMarks::look() {
  if (!shown()) m_layer->setContacts({});
  m_isStale = true;
  if (!m_isUnderWay) find();
}

void CellContactMarks::find() {
  m_isStale = false;
  const Collisions* const collisions = shown();
  if (!collisions) return;
  Job job;
  job.owner = this;
  job.failed = [this](const Error&) {
    m_isUnderWay = false;
    m_layer->setContacts({});
    if (m_isStale) find();
  };
  job.work = [this, cell = m_cell, collisions = *collisions](Progress progress) -> Job::Finish {
    std::vector<ContactMark> marks;
    for (const CellContact& contact : contactsOf(collisions, kMostMarked, progress))
      marks.push_back({contact.position, contact.normal});
    return [this, cell, marks = std::move(marks)]() mutable {
      m_isUnderWay = false;
      if (cell == m_cell && shown()) m_layer->setContacts(std::move(marks));
      if (m_isStale) find();
    };
  };
  m_isUnderWay = true;
  m_finding.start(std::move(job));
}

}  // namespace handwheel
