local fr = require "flyrock"
return fr.plugin { kind = "restitution" name = "hostile" }
