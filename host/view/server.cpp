// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <thread>
#include <utility>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kLoopback[] = "127.0.0.1";
constexpr unsigned kPorts = 100;  ///< tries so many ports
constexpr std::size_t kLongestQuestion = 1 << 20;

constexpr int kRefused = 400, kForeign = 403, kMissing = 404, kMistaken = 422, kFailed = 500;

void refuse_request(httplib::Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(Json{{"error", sentence}}.dump(), "application/json");
}

/// The library's own options would let two programs listen on one port.
void keep_port_alone(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

struct ViewServer::State {
  httplib::Server http;
  std::map<std::string, PageFile> files;
  std::function<Answer(const Json&)> answer;
  unsigned port = 0;
  std::thread listener;

  /// Whether the browser asks for a page of ours, under this address. Another name of the computer
  /// in "Host" is that of a foreign page which has had it resolved to here.
  bool is_ours(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host");
    const std::string port_text = fmt::format(":{}", port);
    if (host != kLoopback + port_text && host != "localhost" + port_text) return false;
    const std::string origin = request.get_header_value("Origin");
    if (!origin.empty() && origin != "http://" + host) return false;
    const std::string site = request.get_header_value("Sec-Fetch-Site");
    return site.empty() || site == "same-origin" || site == "none";
  }

  void give_file(const httplib::Request& request, httplib::Response& response) const {
    const auto file = files.find(request.path);
    if (file == files.end()) {
      refuse_request(response, kMissing, "the page has no such file");
    } else {
      response.set_content(file->second.text, file->second.type);
    }
  }

  void give_answer(const httplib::Request& request, httplib::Response& response) const {
    try {
      if (request.get_header_value("Content-Type") != "application/json") {
        throw NotOurs("its content is not JSON");
      }
      const std::string bytes = answer(question_of(request.body)).bytes();
      response.set_content(bytes, "application/octet-stream");
    } catch (const NotOurs& error) {
      refuse_request(response, kRefused, error.what());
    } catch (const UserError& error) {
      refuse_request(response, kMistaken, error.what());
    } catch (const std::exception& error) {
      refuse_request(response, kFailed, error.what());
    }
  }
};

ViewServer::ViewServer(std::map<std::string, PageFile> files, unsigned port,
                       std::function<Answer(const Json&)> answer)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.files = std::move(files);
  state.answer = std::move(answer);
  httplib::Server& http = state.http;
  http.set_socket_options(keep_port_alone);
  http.set_payload_max_length(kLongestQuestion);
  http.set_keep_alive_max_count(1);  // after each answer the connection is closed
  http.set_tcp_nodelay(true);
  http.set_default_headers({{"Cache-Control", "no-store"},
                            {"Content-Security-Policy",
                             "default-src 'self'; img-src 'self' data: blob:; style-src 'self' "
                             "'unsafe-inline'; frame-ancestors 'none'"},
                            {"Cross-Origin-Resource-Policy", "same-origin"},
                            {"X-Content-Type-Options", "nosniff"}});
  http.set_pre_routing_handler([&state](const auto& request, auto& response) {
    using enum httplib::Server::HandlerResponse;
    if (state.is_ours(request)) return Unhandled;
    refuse_request(response, kForeign, "this address answers its own page alone");
    return Handled;
  });
  http.Get(".*",
           [&state](const auto& request, auto& response) { state.give_file(request, response); });
  http.Post("/ask", [&state](const auto& request, auto& response) {
    state.give_answer(request, response);
  });
  for (unsigned next = port; next < port + kPorts && next <= 65535 && state.port == 0; ++next) {
    if (http.bind_to_port(kLoopback, static_cast<int>(next))) state.port = next;
  }
  if (state.port == 0) {
    refuse("the ports {} to {} of this computer are all in use; name another port", port,
           port + kPorts - 1);
  }
  state.listener = std::thread([&http] { http.listen_after_bind(); });
  while (!http.is_running()) std::this_thread::yield();
}

ViewServer::~ViewServer() {
  state_->http.stop();
  state_->listener.join();
}

unsigned ViewServer::port() const { return state_->port; }
std::string ViewServer::address() const {
  return fmt::format("http://{}:{}/", kLoopback, state_->port);
}

}  // namespace dynrt::host
