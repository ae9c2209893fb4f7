// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/ForceRecorder.h"
#include "haptics/recording/RecordingCsv.h"

#include <array>
#include <charconv>
#include <optional>

namespace handwheel {

namespace {

// The inputs of a force, then the force itself, then words.
// clang-format off
enum Column {
  Time, X, Y, Z, Qw, Qx, Qy, Qz, Vx, Vy, Vz, Period, Stiffness, Damping, Restart, HasSource, Buttons, Tick,
  Contact, ForceX, ForceY, ForceZ, ProxyX, ProxyY, ProxyZ, Event, Scene, kColumns
};
constexpr std::array<std::string_view, kColumns> kNames{
    "t_s", "hip_x", "hip_y", "hip_z", "hip_qw", "hip_qx", "hip_qy", "hip_qz", "hip_vx", "hip_vy", "hip_vz", "period_s",
    "stiffness_limit", "damping_limit", "restart", "in_scene", "buttons", "tick", "contact", "force_x", "force_y", "force_z",
    "proxy_x", "proxy_y", "proxy_z", "event", "scene"};  // clang-format on
constexpr std::size_t kUnused = ~std::size_t{0};

// Takes the next field off a line of comma-separated values (RFC 4180), its quotes removed. None at the end of the
// line. A field in quotes may hold line breaks.
class Fields {
 public:
  explicit Fields(std::string_view text) : m_rest(text) {}

  bool isAtEnd() const { return m_rest.empty(); }
  std::size_t left() const { return m_rest.size(); }  // bytes
  std::uint64_t line() const { return m_line; }

  // Starts the next line. False at the end of the text.
  bool nextLine() {
    if (isAtEnd()) return false;
    m_isLineDone = false;
    m_line = m_nextLine++;
    return true;
  }

  // The view is valid until the next call.
  std::optional<std::string_view> next() {
    if (m_isLineDone) return std::nullopt;
    return m_rest.starts_with('"') ? quoted() : plain();
  }

 private:
  std::string_view plain() {
    const std::size_t end = std::min(m_rest.find_first_of(",\n"), m_rest.size());
    std::string_view field = m_rest.substr(0, end);
    endField(end);
    while (field.ends_with('\r')) field.remove_suffix(1);
    return field;
  }

  std::string_view quoted() {
    m_field.clear();
    std::size_t i = 1;
    for (; i < m_rest.size(); ++i) {
      if (m_rest[i] == '\n') ++m_nextLine;
      if (m_rest[i] == '"') {
        if (i + 1 >= m_rest.size() || m_rest[i + 1] != '"') break;
        ++i;
      }
      m_field += m_rest[i];
    }
    endField(std::min(m_rest.find_first_of(",\n", i), m_rest.size()));
    return m_field;
  }

  void endField(std::size_t end) {
    m_isLineDone = end == m_rest.size() || m_rest[end] == '\n';
    m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
  }

  std::string_view m_rest;
  std::string m_field;
  bool m_isLineDone = true;
  std::uint64_t m_line = 0, m_nextLine = 1;
};

// Returns the column of each field of a line.
std::vector<std::size_t> columnsOf(Fields& fields) {
  std::vector<std::size_t> columns;
  if (!fields.nextLine()) return columns;
  while (const auto name = fields.next()) {
    const auto at = std::find(kNames.begin(), kNames.end(), *name);
    columns.push_back(at == kNames.end() ? kUnused : static_cast<std::size_t>(at - kNames.begin()));
  }
  return columns;
}

std::vector<std::string_view> missingFrom(const std::vector<std::size_t>& columns) {
  std::vector<std::string_view> missing;
  for (std::size_t c = 0; c < kColumns; ++c) {
    if (std::count(columns.begin(), columns.end(), c) != 1) missing.push_back(kNames[c]);
  }
  return missing;
}

class TableReader {
 public:
  explicit TableReader(std::string_view text) : m_fields(text), m_size(text.size()) {}

  Result<Recording> read(Progress progress) {
    m_columns = columnsOf(m_fields);
    if (!missingFrom(m_columns).empty()) return wrong(ErrorCode::HeaderMalformed, {"the columns of a recording"});
    for (std::size_t i = 0; m_fields.nextLine(); ++i) {
      if (i % kLinesPerPoll == 0) {
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
        progress.set(1.0 - static_cast<double>(m_fields.left()) / static_cast<double>(m_size));
      }
      if (i == ForceRecorder::kMostTicks) {
        const std::string most = std::to_string(ForceRecorder::kMostTicks);
        return wrong(ErrorCode::FileTooLarge, {"ticks", "", most});
      }
      if (const Status status = readLine(); !status) return status.error();
    }
    return std::move(m_recording);
  }

 private:
  static constexpr std::size_t kLinesPerPoll = 1024;

  Error wrong(ErrorCode code, std::vector<std::string> arguments) const {
    return {code, std::move(arguments), InputPosition::line(m_fields.line()), {}};
  }

  Status readLine() {
    std::array<double, kColumns> values{};
    std::string event, scene;
    std::size_t field = 0;
    for (; const auto word = m_fields.next(); ++field) {
      const std::size_t column = field < m_columns.size() ? m_columns[field] : kUnused;
      if (column == kUnused) continue;
      if (column == Event) {
        event = *word;
      } else if (column == Scene) {
        scene = *word;
      } else if (!parse(*word, values[column])) {
        return wrong(ErrorCode::NumberMalformed, {std::string(*word)});
      }
    }
    if (field != m_columns.size())
      return wrong(ErrorCode::DataTruncated, {"columns", std::to_string(m_columns.size()), std::to_string(field)});
    for (const Column c : {Time, X, Y, Z}) {
      if (!std::isfinite(values[c])) return wrong(ErrorCode::NumberNotFinite, {std::string(kNames[c])});
    }
    add(values);
    addEvents(event, scene);
    return Done{};
  }

  static bool parse(std::string_view word, double& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }

  // Converts a number of a column of whole numbers; 0 for anything else.
  template <class Number>
  static Number whole(double value) {
    return value >= 0.0 && value <= 9e15 ? static_cast<Number>(value) : Number{0};
  }

  void add(const std::array<double, kColumns>& v) {
    RecordedTick tick;
    tick.tick = whole<std::uint64_t>(v[Tick]);
    TipState& tip = tick.tip;
    tip.time = v[Time];
    tip.position = {v[X], v[Y], v[Z]};
    tip.orientation = Eigen::Quaterniond(v[Qw], v[Qx], v[Qy], v[Qz]);
    tip.velocity = {v[Vx], v[Vy], v[Vz]};
    tip.period = v[Period];
    tip.stiffnessLimit = v[Stiffness];
    tip.dampingLimit = v[Damping];
    tip.isRestart = v[Restart] != 0.0;
    tip.buttons = whole<std::uint32_t>(std::min(v[Buttons], 4294967295.0));
    tick.felt.isContact = v[Contact] != 0.0;
    tick.felt.force = {v[ForceX], v[ForceY], v[ForceZ]};
    tick.felt.proxy = {v[ProxyX], v[ProxyY], v[ProxyZ]};
    tick.hasSource = v[HasSource] != 0.0;
    m_recording.add(tick);
  }

  void addEvents(const std::string& event, std::string_view scenes) {
    const std::uint64_t tick = m_recording[m_recording.size() - 1].tick;
    if (!event.empty()) m_recording.addEvent({tick, event});
    while (!scenes.empty()) {
      const std::string_view scene = scenes.substr(0, scenes.find('\n'));
      m_recording.addEvent({tick, std::string(kSceneEvent) + std::string(scene)});
      scenes.remove_prefix(std::min(scene.size() + 1, scenes.size()));
    }
  }

  Fields m_fields;
  std::size_t m_size;
  std::vector<std::size_t> m_columns;
  Recording m_recording;
};

}  // namespace

std::vector<std::string_view> missingRecordingColumns(std::string_view text) {
  Fields fields(text.substr(0, 4096));
  return missingFrom(columnsOf(fields));
}

bool isRecordingCsv(std::string_view text) {
  return missingRecordingColumns(text).empty();
}

Result<Recording> recordingFromCsv(std::string_view text, Progress progress) {
  return TableReader(text).read(progress);
}

}  // namespace handwheel
