// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handwheel::haply {

// How a WebSocket is opened (RFC 6455, sections 1.3 and 4.1).

// 16 random bytes in base64, new for each connection.
std::string handshakeKey();
// What a server answers to a key: who does that speaks the protocol, and has read this very request.
std::string acceptFor(std::string_view key);

std::string upgradeRequest(std::string_view host, std::string_view key);
// Whether this is a server's consent, from "HTTP/1.1" up to the empty line; names of fields in any case.
bool isConsent(std::string_view head, std::string_view key);

}  // namespace handwheel::haply
