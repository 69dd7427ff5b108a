return require "parts.circle_a"
