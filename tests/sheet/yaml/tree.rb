# YAML files as lines: file and path, number or text, value.
require 'yaml'

def walk(path, value)
  case value
  when Hash then value.each { |key, item| walk("#{path}/#{key.is_a?(String) ? key : key.inspect}", item) }
  when Array then value.each_with_index { |item, i| walk("#{path}/#{i}", item) }
  when Integer, Float then puts [path, 'number', [value.to_f].pack('G').unpack1('H*')].join("\t")
  when String then puts [path, 'text', value.gsub("\n", '\n')].join("\t")
  else puts [path, value.class, value.inspect].join("\t")
  end
end

ARGV.each { |file| walk(file, YAML.safe_load(File.read(file, encoding: 'UTF-8'))) }
