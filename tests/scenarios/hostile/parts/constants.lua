return { en = 0.3, calls = { 0 } }
