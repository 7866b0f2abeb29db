# A YAML file as lines: path, number or text, value.
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

walk('', YAML.safe_load(File.read(ARGV[0], encoding: 'UTF-8')))
