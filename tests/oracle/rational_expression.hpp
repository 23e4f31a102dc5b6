// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>

namespace triplex::oracle {

/// Evaluates text such as "3/4*(x - y)^2 - z" in rational numbers: whole numbers, x, y, z, + - * /,
/// whole powers and brackets. \throw std::invalid_argument for anything else.
class RationalExpression {
 public:
  static mpq_class evaluate(std::string_view text, const std::array<mpq_class, 3>& at) {
    RationalExpression e(text, at);
    mpq_class value = e.sum();
    if (e.peek() != '\0') e.fail();
    return value;
  }

 private:
  RationalExpression(std::string_view text, const std::array<mpq_class, 3>& at)
      : text_(text), at_(at) {}

  [[noreturn]] void fail() const {
    throw std::invalid_argument("no expression: " + std::string(text_));
  }
  char peek() {
    while (next_ < text_.size() && text_[next_] == ' ') ++next_;
    return next_ < text_.size() ? text_[next_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++next_;
    return true;
  }
  mpq_class sum() {
    mpq_class value = take('-') ? mpq_class(-term()) : term();
    for (;;) {
      if (take('+')) {
        value += term();
      } else if (take('-')) {
        value -= term();
      } else {
        return value;
      }
    }
  }
  mpq_class term() {
    mpq_class value = power();
    for (;;) {
      if (take('*')) {
        value *= power();
      } else if (take('/')) {
        value /= power();
      } else {
        return value;
      }
    }
  }
  mpq_class power() {
    const mpq_class base = factor();
    if (!take('^')) return base;
    mpq_class value = 1;
    for (mpz_class n = integer(); n > 0; --n) value *= base;
    return value;
  }
  mpq_class factor() {
    if (take('(')) {
      mpq_class value = sum();
      if (!take(')')) fail();
      return value;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (take("xyz"[k])) return at_[k];
    }
    return integer();
  }
  mpz_class integer() {
    std::string digits;
    while (std::isdigit(static_cast<unsigned char>(peek())) != 0) digits += text_[next_++];
    if (digits.empty()) fail();
    return mpz_class(digits);
  }

  std::string_view text_;
  const std::array<mpq_class, 3>& at_;
  std::size_t next_ = 0;
};

}  // namespace triplex::oracle
