// The headers that nearly every test includes, compiled once.
